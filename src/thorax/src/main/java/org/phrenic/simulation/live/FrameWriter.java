package org.phrenic.simulation.live;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Works on the frames of a scene on a thread of its own, one at a time, while the simulation goes on. Used by one
 * thread at a time; what a task writes is visible to that thread after {@link #finish}.
 */
final class FrameWriter implements AutoCloseable {
    private final ExecutorService worker = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "phrenic-frames");
        thread.setDaemon(true);
        return thread;
    });
    private Future<?> pending;

    /** Starts a task; the one before is finished first. */
    void start(Runnable task) {
        finish();
        pending = worker.submit(task);
    }

    /** Whether no task is at work. */
    boolean isIdle() {
        return pending == null || pending.isDone();
    }

    /** Waits for the task at work; its exception is thrown here. */
    void finish() {
        Future<?> last = pending;
        pending = null;
        boolean interrupted = false;
        while (last != null) {
            try {
                last.get();
                last = null;
            } catch (InterruptedException e) {
                interrupted = true;
            } catch (ExecutionException e) {
                if (e.getCause() instanceof Error error) {
                    throw error;
                }
                throw e.getCause() instanceof RuntimeException cause ? cause : new IllegalStateException(e.getCause());
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Ends the thread after the task at work, whose exception is thrown here. */
    @Override
    public void close() {
        try {
            finish();
        } finally {
            worker.shutdown();
        }
    }
}
