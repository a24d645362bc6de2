package org.phrenic.ui.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** What the process writes in the background, so that it does not end amid a file or a folder. On any thread. */
public final class FileWrites {
    private static final List<FileWrites> UNDER_WAY = new ArrayList<>();
    private static final List<Runnable> WAITING = new ArrayList<>();

    private final String what;

    private FileWrites(String what) {
        this.what = what;
    }

    /**
     * Begins to write.
     *
     * @param what a file or folder, in the words for the user
     */
    public static FileWrites begin(String what) {
        FileWrites begun = new FileWrites(what);
        synchronized (UNDER_WAY) {
            UNDER_WAY.add(begun);
        }
        return begun;
    }

    /** Ends to write, whole or not. */
    public void end() {
        synchronized (UNDER_WAY) {
            UNDER_WAY.remove(this);
            if (UNDER_WAY.isEmpty()) {
                WAITING.forEach(SwingUtilities::invokeLater);
                WAITING.clear();
            }
        }
    }

    /** What is being written, the first of it; empty if nothing is. */
    public static Optional<String> underWay() {
        synchronized (UNDER_WAY) {
            return UNDER_WAY.stream().findFirst().map(one -> one.what);
        }
    }

    /** Runs a task on the event dispatch thread once nothing is being written. */
    public static void whenDone(Runnable task) {
        synchronized (UNDER_WAY) {
            if (UNDER_WAY.isEmpty()) {
                SwingUtilities.invokeLater(task);
            } else {
                WAITING.add(task);
            }
        }
    }

    /** As {@link BackgroundWorker#execute}, of a task that writes. */
    public static <T> void execute(String what, Callable<T> task, Consumer<T> onDone, Consumer<String> onFailure) {
        FileWrites writing = begin(what);
        Callable<T> counted = () -> {
            try {
                return task.call();
            } finally {
                writing.end();
            }
        };
        BackgroundWorker.execute(counted, onDone, onFailure);
    }
}
