package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.file.UserCache;
import org.phrenic.scenario.Scenario;

/** A scene that settles says how far it has come, which takes long with a short time step. */
class SettlingProgressTest {
    private static final class Told implements SimulationRun.Progress {
        private final List<Double> shares = new ArrayList<>();

        @Override
        public void advanced(double simulatedS, double totalS, double stepsPerS) {
            throw new AssertionError("no step of the run is made");
        }

        @Override
        public void settling(double doneS, double totalS) {
            shares.add(doneS / totalS);
        }
    }

    @Test
    void settlingIsTold() {
        Scenario scenario = Runs.scenario(Runs.sheetAlone("time_step_s=0.001"));
        Told told = new Told();
        try (Simulation simulation = Simulation.of(scenario, Runs.male(), UserCache.off(), told)) {
            assertThat(simulation.steps()).isZero();
        }
        // Half a second is 500 steps.
        assertThat(told.shares).hasSize(5).isSorted().allMatch(share -> share > 0 && share < 1);
    }
}
