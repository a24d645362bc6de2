package org.phrenic.simulation.live;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;

/** Commands from other threads that one thread executes in order of submission, between its own tasks. */
final class CommandQueue {
    private final Queue<Runnable> queue = new ArrayDeque<>();
    private Thread owner;
    private boolean closed;

    /** Sets the thread that executes the commands. */
    synchronized void bindTo(Thread thread) {
        owner = thread;
    }

    /** Submits a command; false if the queue is closed and the command will not be executed. */
    synchronized boolean submit(Runnable command) {
        if (closed) {
            return false;
        }
        queue.add(command);
        wake();
        return true;
    }

    /** Evaluates a supplier on the executing thread and waits for the result. */
    <T> T submitAndWait(Supplier<T> question) {
        if (isOwner()) {
            return question.get();
        }
        CompletableFuture<T> answer = new CompletableFuture<>();
        boolean asked = submit(() -> {
            try {
                answer.complete(question.get());
            } catch (RuntimeException | Error e) {
                answer.completeExceptionally(e);
            }
        });
        // The thread has ended, so its state is constant and can be read from this thread.
        return asked ? answer.join() : question.get();
    }

    private synchronized boolean isOwner() {
        return Thread.currentThread() == owner;
    }

    /** Interrupts a wait of the executing thread. */
    synchronized void wake() {
        LockSupport.unpark(owner);
    }

    /** Executes all submitted commands; on the executing thread. */
    void drain() {
        for (Runnable next = poll(); next != null; next = poll()) {
            next.run();
        }
    }

    private synchronized Runnable poll() {
        return queue.poll();
    }

    /** Waits for at most this time, ns, or until a command arrives; on the executing thread. */
    static void await(long ns) {
        LockSupport.parkNanos(ns);
    }

    /** Refuses further commands and executes the remaining ones; on the executing thread. */
    void close() {
        synchronized (this) {
            closed = true;
        }
        drain();
    }
}
