package org.phrenic.simulation;

import org.phrenic.file.BadInputException;
import org.phrenic.file.JavaMemory;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Observation;

/** The rows of observables that a run keeps until it writes them at its end. */
final class ObservableRows {
    /** A row takes some objects besides its values. It is written without a copy of the others. */
    private static final long BYTES_A_ROW = (long) Double.BYTES * Observation.COLUMNS.size() + 64;
    /** Share of Java's memory that they may take, beside the scene. */
    private static final double SHARE_OF_MEMORY = 0.8;

    private ObservableRows() {}

    /**
     * Refuses a run of more rows than there is room for.
     *
     * @param memory what Java may use, bytes
     * @throws BadInputException with one sentence
     */
    static void require(Scenario scenario, long memory) {
        long rows = count(scenario);
        if (rows > SHARE_OF_MEMORY * memory / BYTES_A_ROW) {
            throw new BadInputException(
                    RunSettings.RECORD_EVERY.key() + ": found " + scenario.text(RunSettings.RECORD_EVERY) + " s, with "
                            + rows + " rows of observables, expected no more than fit into Java's memory of "
                            + JavaMemory.inWords(memory));
        }
    }

    private static long count(Scenario scenario) {
        double dt = scenario.timeStepS();
        long steps = scenario.steps() >= 0
                ? scenario.steps()
                : SimulationRun.stepsFor(scenario.durationS(Breathing.patternOf(scenario)), dt);
        return 1 + steps / SimulationRun.sampleInterval(scenario.get(RunSettings.RECORD_EVERY), dt);
    }
}
