package org.phrenic.ui.session;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import javax.swing.SwingWorker;
import org.phrenic.simulation.live.LiveRun;

/**
 * One thread that runs tasks one after the other; their results are delivered on the event dispatch thread unless they
 * were discarded meanwhile. Used on the event dispatch thread.
 */
public final class BackgroundWorker implements AutoCloseable {
    private final ExecutorService thread;
    private long generation;

    /** @param name of the thread */
    public BackgroundWorker(String name) {
        thread = daemonThread(name);
    }

    /** A thread that does not keep the program alive. */
    public static ExecutorService daemonThread(String name) {
        return Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        });
    }

    /**
     * Runs a task on one of Swing's worker threads, beside all others.
     *
     * @param onDone gets the result on the event dispatch thread
     * @param onFailure gets the exception's message on the event dispatch thread
     */
    public static <T> void execute(Callable<T> task, Consumer<T> onDone, Consumer<String> onFailure) {
        new SwingWorker<T, Void>() {
            @Override
            protected T doInBackground() throws Exception {
                return task.call();
            }

            @Override
            protected void done() {
                T result;
                try {
                    result = get();
                } catch (ExecutionException e) {
                    onFailure.accept(message(e.getCause()));
                    return;
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                    return;
                }
                onDone.accept(result);
            }
        }.execute();
    }

    private static String message(Throwable failure) {
        if (failure instanceof OutOfMemoryError) {
            return "There is not enough memory; " + LiveRun.FREE_MEMORY + ".";
        }
        return failure.getMessage() == null ? failure.toString() : failure.getMessage();
    }

    /** Results of all tasks submitted so far are dropped. */
    public void discardPending() {
        generation++;
    }

    /** Tells whether nothing was discarded since this call. */
    public BooleanSupplier notDiscardedSince() {
        long now = generation;
        return () -> now == generation;
    }

    /**
     * Runs a task after those submitted before.
     *
     * @param onDone gets the result, unless it is discarded
     * @param onFailure gets the exception's message, unless it is discarded
     */
    public <T> void run(Callable<T> task, Consumer<T> onDone, Consumer<String> onFailure) {
        submit(task, onDone, onFailure, notDiscardedSince());
    }

    /** As {@link #run}, with a result that is never discarded. */
    public <T> void runAlways(Callable<T> task, Consumer<T> onDone, Consumer<String> onFailure) {
        submit(task, onDone, onFailure, () -> true);
    }

    private <T> void submit(Callable<T> task, Consumer<T> onDone, Consumer<String> onFailure, BooleanSupplier wanted) {
        try {
            thread.execute(() -> {
                Runnable outcome;
                try {
                    T result = task.call();
                    outcome = () -> onDone.accept(result);
                } catch (Exception | Error e) {
                    outcome = () -> onFailure.accept(message(e));
                }
                Runnable delivery = outcome;
                SwingUtilities.invokeLater(() -> {
                    if (wanted.getAsBoolean()) {
                        delivery.run();
                    }
                });
            });
        } catch (RejectedExecutionException closing) {
            // The window is being closed: no one waits for the result.
            discardPending();
        }
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
