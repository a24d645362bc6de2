package org.phrenic.simulation.live;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * Works on the frames of a scene on a thread of its own, one at a time, while the simulation goes on. Used by one
 * thread at a time; what a task writes is visible to that thread after {@link #finish}.
 */
final class FrameWriter implements AutoCloseable {
    private final BlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
    private final Thread thread = new Thread(this::serve, "phrenic-frames");
    private FutureTask<Void> pending;
    private boolean started;

    FrameWriter() {
        thread.setDaemon(true);
    }

    /** Starts a task; the one before is finished first. */
    void start(Runnable task) {
        finish();
        if (!started) {
            started = true;
            thread.start();
        }
        pending = new FutureTask<>(task, null);
        tasks.add(pending);
    }

    /** Whether no task is at work. */
    boolean isIdle() {
        return pending == null || pending.isDone();
    }

    /** Waits for the task at work; its exception is thrown here. */
    void finish() {
        FutureTask<Void> last = pending;
        pending = null;
        boolean interrupted = false;
        while (last != null) {
            try {
                last.get();
                last = null;
            } catch (InterruptedException e) {
                interrupted = true;
            } catch (ExecutionException e) {
                throw e.getCause() instanceof RuntimeException cause ? cause : new IllegalStateException(e.getCause());
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void serve() {
        try {
            while (true) {
                tasks.take().run();
            }
        } catch (InterruptedException e) {
            // Closed.
            return;
        }
    }

    /** Ends the thread after the task at work. */
    @Override
    public void close() {
        finish();
        thread.interrupt();
    }
}
