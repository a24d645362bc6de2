package org.phrenic.simulation.live;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;

/** What other threads ask of one, done by it between two pieces of its own work, in the order asked. */
final class Commands {
    private final Queue<Runnable> waiting = new ArrayDeque<>();
    private Thread servant;
    private boolean ended;

    /** Whose thread does them. */
    synchronized void serveOn(Thread thread) {
        servant = thread;
    }

    /** Asks for something; false if the thread has ended and it will not be done. */
    synchronized boolean submit(Runnable command) {
        if (ended) {
            return false;
        }
        waiting.add(command);
        wake();
        return true;
    }

    /** Asks on the thread and waits for the answer. */
    <T> T ask(Supplier<T> question) {
        if (isServant()) {
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

    private synchronized boolean isServant() {
        return Thread.currentThread() == servant;
    }

    /** Ends a wait of the thread. */
    synchronized void wake() {
        LockSupport.unpark(servant);
    }

    /** Does all that was asked; on the thread. */
    void runAll() {
        for (Runnable next = poll(); next != null; next = poll()) {
            next.run();
        }
    }

    private synchronized Runnable poll() {
        return waiting.poll();
    }

    /** Waits so long, ns, or until something is asked; on the thread. */
    static void await(long ns) {
        LockSupport.parkNanos(ns);
    }

    /** Takes nothing more, and does what is left; on the thread. */
    void end() {
        synchronized (this) {
            ended = true;
        }
        runAll();
    }
}
