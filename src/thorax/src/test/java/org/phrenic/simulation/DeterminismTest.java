package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.file.Hashes;

class DeterminismTest {
    private static final int STEPS = 80;

    private static String state(int threads) {
        try (Simulation simulation = Simulation.of(Runs.scenario("threads=" + threads, "preset=sniff"), Runs.male())) {
            for (int i = 0; i < STEPS; i++) {
                simulation.step();
            }
            return Hashes.sha256(
                    simulation.system().positions(), simulation.system().velocities());
        }
    }

    @Test
    void theSameScenarioGivesTheSameBitsOnAnyNumberOfThreadsAndAgain() {
        String once = state(2);
        assertThat(state(2)).as("again").isEqualTo(once);
        assertThat(state(1)).as("one thread").isEqualTo(once);
        assertThat(state(3)).as("three threads").isEqualTo(once);
    }
}
