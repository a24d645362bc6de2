package org.phrenic.ui.session;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/**
 * Work beside the event dispatch thread, one piece after the other; what it gives comes back there, unless it was
 * dropped meanwhile. Used on the event dispatch thread.
 */
public final class BackgroundWorker implements AutoCloseable {
    private final ExecutorService worker;
    private long generation;

    /** @param name of the thread */
    public BackgroundWorker(String name) {
        worker = daemonThread(name);
    }

    /** A thread that does not keep the program alive. */
    public static ExecutorService daemonThread(String name) {
        return Executors.newSingleThreadExecutor(work -> {
            Thread made = new Thread(work, name);
            made.setDaemon(true);
            return made;
        });
    }

    /** What was begun so far comes to nothing. */
    public void discardPending() {
        generation++;
    }

    /** Says from now on whether nothing was dropped since. */
    public BooleanSupplier notDiscardedSince() {
        long now = generation;
        return () -> now == generation;
    }

    /**
     * Does something.
     *
     * @param then told what came of it
     * @param refused told in one sentence why nothing came of it
     */
    public <T> void run(Callable<T> what, Consumer<T> then, Consumer<String> refused) {
        BooleanSupplier wanted = notDiscardedSince();
        submit(what, then, refused, wanted);
    }

    /** As {@link #run}, and what comes of it is told in any case. */
    public <T> void runAlways(Callable<T> what, Consumer<T> then, Consumer<String> refused) {
        submit(what, then, refused, () -> true);
    }

    private <T> void submit(Callable<T> what, Consumer<T> then, Consumer<String> refused, BooleanSupplier wanted) {
        try {
            worker.execute(() -> {
                Runnable told;
                try {
                    T made = what.call();
                    told = () -> then.accept(made);
                } catch (Exception e) {
                    String sentence = e.getMessage() == null ? e.toString() : e.getMessage();
                    told = () -> refused.accept(sentence);
                }
                Runnable tell = told;
                SwingUtilities.invokeLater(() -> {
                    if (wanted.getAsBoolean()) {
                        tell.run();
                    }
                });
            });
        } catch (RejectedExecutionException closing) {
            // The window is being closed: nobody waits for it.
            discardPending();
        }
    }

    @Override
    public void close() {
        worker.shutdownNow();
    }
}
