package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.file.Hashes;

class DeterminismTest {
    private static final int STEPS = 80;

    /** The state after some steps of a new simulation, and after as many of the same one from its rest. */
    private static List<String> states(int threads, int times) {
        try (Simulation simulation = Simulation.of(Runs.scenario("threads=" + threads, "preset=sniff"), Runs.male())) {
            List<String> states = new ArrayList<>();
            while (states.size() < times) {
                simulation.restart();
                for (int i = 0; i < STEPS; i++) {
                    simulation.step();
                }
                states.add(Hashes.sha256(
                        simulation.system().positions(), simulation.system().velocities()));
            }
            return states;
        }
    }

    @Test
    void theSameScenarioGivesTheSameBitsOnAnyNumberOfThreadsAndAgain() {
        List<String> two = states(2, 2);
        String once = two.get(0);
        assertThat(two.get(1)).as("again").isEqualTo(once);
        assertThat(states(1, 1)).as("one thread").containsExactly(once);
        assertThat(states(3, 1)).as("three threads").containsExactly(once);
    }
}
