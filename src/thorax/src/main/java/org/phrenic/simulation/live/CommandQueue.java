package org.phrenic.simulation.live;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;

/** What other threads ask of one, done by it between two pieces of its own work, in the order asked. */
final class CommandQueue {
    private final Queue<Runnable> queue = new ArrayDeque<>();
    private Thread owner;
    private boolean closed;

    /** Whose thread does them. */
    synchronized void bindTo(Thread thread) {
        owner = thread;
    }

    /** Asks for something; false if the thread has ended and it will not be done. */
    synchronized boolean submit(Runnable command) {
        if (closed) {
            return false;
        }
        queue.add(command);
        wake();
        return true;
    }

    /** Asks on the thread and waits for the answer. */
    <T> T submitAndWait(Supplier<T> question) {
        if (isOwner()) {
            return question.get();
        }
        CompletableFuture<T> answer = new CompletableFuture<>();
        boolean asked = submit(() -> {
            try {
                answer.complete(question.get());
            } catch (RuntimeException e) {
                answer.completeExceptionally(e);
            }
        });
        // What has ended stands still: it can be looked at from here.
        return asked ? answer.join() : question.get();
    }

    private synchronized boolean isOwner() {
        return Thread.currentThread() == owner;
    }

    /** Ends a wait of the thread. */
    synchronized void wake() {
        LockSupport.unpark(owner);
    }

    /** Does all that was asked; on the thread. */
    void drain() {
        for (Runnable next = poll(); next != null; next = poll()) {
            next.run();
        }
    }

    private synchronized Runnable poll() {
        return queue.poll();
    }

    /** Waits so long, ns, or until something is asked; on the thread. */
    static void await(long ns) {
        LockSupport.parkNanos(ns);
    }

    /** Takes nothing more, and does what is left; on the thread. */
    void close() {
        synchronized (this) {
            closed = true;
        }
        drain();
    }
}
