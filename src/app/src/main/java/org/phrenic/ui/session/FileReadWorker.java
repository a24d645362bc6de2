package org.phrenic.ui.session;

import java.nio.file.Path;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingWorker;

/** Reads a file off the event dispatch thread. */
public final class FileReadWorker<T> extends SwingWorker<T, Void> {
    private final Path file;
    private final Supplier<T> read;
    private final Consumer<T> onRead;
    private final Consumer<String> onFailure;

    /**
     * @param file for the sentence where nothing else is known
     * @param read what reads it; its exceptions have the sentence for people
     * @param whenRead told what was read, on the event dispatch thread
     * @param whenRefused told in one sentence what is wrong with the file, on the event dispatch thread
     */
    public FileReadWorker(Path file, Supplier<T> read, Consumer<T> whenRead, Consumer<String> whenRefused) {
        this.file = file;
        this.read = read;
        this.onRead = whenRead;
        this.onFailure = whenRefused;
    }

    @Override
    protected T doInBackground() {
        return read.get();
    }

    @Override
    protected void done() {
        try {
            onRead.accept(get());
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            onFailure.accept(cause.getMessage() == null ? file + ": could not be read" : cause.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
