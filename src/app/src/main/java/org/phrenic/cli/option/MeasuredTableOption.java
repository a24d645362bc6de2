package org.phrenic.cli.option;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.error.ErrorTable;
import picocli.CommandLine.Option;

/** The option {@code --write} of {@code phrenic bench error}: a table that the measured rows are put into. */
public final class MeasuredTableOption {
    @Option(
            names = "--write",
            paramLabel = "FILE",
            description =
                    "Table to put the rows into, such as data/error/settings.csv, from which run --max-error chooses.")
    private Path table;

    private ErrorTable earlier = ErrorTable.EMPTY;
    private boolean replacesScenes;

    /** Refuses a file that cannot be written. */
    public void requireWritable() {
        ReportFolder.requireWritableFile("--write", table);
    }

    /**
     * Reads the table, if the option is given, before anything is measured. Rows are refused that the table would hold
     * for those of another scene, or beside rows over another time or of another number of threads.
     *
     * @param settings further settings of the scenarios
     * @param replacesScenes whether all settings of the scenarios are measured, which replace all rows of their scenes
     * @param simulatedS simulated time, s
     */
    public void open(
            List<Assignment> settings,
            List<Scenario> scenarios,
            boolean replacesScenes,
            ToDoubleFunction<Scenario> simulatedS) {
        if (table == null) {
            return;
        }
        this.replacesScenes = replacesScenes;
        settings.stream().filter(set -> !set.key().equals("preset")).findFirst().ifPresent(set -> {
            throw new BadInputException(set.origin()
                    + ": found it with --write, expected preset alone: a row names no other key of its scene");
        });
        scenarios.stream()
                .filter(scenario -> scenario.threads() > 1)
                .findFirst()
                .ifPresent(scenario -> {
                    throw new BadInputException("--threads: found " + scenario.threads()
                            + " with --write, expected 1: a row names no number of threads, and its costs are of one");
                });
        if (Files.exists(table)) {
            earlier = ErrorTable.read(table);
        }
        if (!replacesScenes) {
            scenarios.forEach(scenario -> earlier.requireTime(scenario, simulatedS.applyAsDouble(scenario)));
        }
    }

    /** Writes the table with the measured rows, if the option is given. */
    public void put(ErrorTable measured) {
        if (table != null) {
            (replacesScenes ? earlier.with(measured) : earlier.withSettings(measured)).write(table);
        }
    }
}
