package org.phrenic.ui;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;
import org.phrenic.format.BadInputException;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Scenario;

/** Reads what was dropped or opened, off the event dispatch thread: a scenario, a thorax folder or a recorded trace. */
final class Opening extends SwingWorker<Scenario, Void> {
    private final Path file;
    private final Scenario present;
    private final Consumer<Scenario> whenRead;
    private final Consumer<String> whenRefused;

    /**
     * @param present scenario into which a folder or a trace goes
     * @param whenRead told the scenario that results, on the event dispatch thread
     * @param whenRefused told in one sentence what is wrong with the file, on the event dispatch thread
     */
    Opening(Path file, Scenario present, Consumer<Scenario> whenRead, Consumer<String> whenRefused) {
        this.file = file;
        this.present = present;
        this.whenRead = whenRead;
        this.whenRefused = whenRefused;
    }

    @Override
    protected Scenario doInBackground() {
        return read(file, present);
    }

    /**
     * The scenario that a file makes of the present one.
     *
     * @throws BadInputException with one sentence
     */
    static Scenario read(Path file, Scenario present) {
        if (!Files.exists(file)) {
            throw new BadInputException(
                    file + ": found nothing there, expected a scenario, a thorax folder or a trace");
        }
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        String place = file.toAbsolutePath().normalize().toString();
        if (Files.isDirectory(file)) {
            return present.with(List.of(new Assignment(file.toString(), "anatomy", place)));
        }
        if (name.endsWith(".csv")) {
            return present.with(List.of(new Assignment(file.toString(), "trace", place)));
        }
        if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            return Scenario.read(file);
        }
        throw new BadInputException(file
                + ": found a file of another kind, expected a scenario (.yaml), a thorax folder or a trace (.csv)");
    }

    @Override
    protected void done() {
        try {
            whenRead.accept(get());
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            whenRefused.accept(cause.getMessage() == null ? file + ": could not be read" : cause.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
