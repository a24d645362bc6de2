package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

class TissueMassTest {
    /** Springs of the lungs do not change with the muscle's, so that their nodes need no other least mass. */
    @Test
    void aLiveChangeOfTheMuscleGivesLungsTheMassesOfASceneAssembledWithIt() {
        Scenario usual = Scenario.defaults().with("resolution=low", "sternum=kinematic", "threads=1");
        String change = "muscle_stiffness_n_per_m=" + 0.5 * usual.get(SheetSprings.MUSCLE_STIFFNESS);
        try (Simulation live = Runs.simulation(usual);
                Simulation assembled = Runs.simulation(usual.with(change))) {
            live.change(Assignment.parse(change));
            while (live.time() < 1) {
                live.step();
            }
            ParticleSystem system = live.scene().system();
            double[] expected = assembled.scene().nodeMasses().all();
            for (int i = 0; i < expected.length; i++) {
                int node = system.layout().caller(i);
                if (node >= live.scene().firstLungNode()) {
                    assertThat(system.masses()[i]).as("node %d", node).isCloseTo(expected[node], withPercentage(1e-6));
                }
            }
        }
    }

    /** The force on a node of mass m and velocity v is -γ v; in a sheet of usual size γ / m is the rate, 1/s. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 5, 40})
    void dampingOverMassIsTheRateOfTheScenario(double rate) {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone("damping_rate_per_s=" + rate)))) {
            ParticleSystem system = simulation.scene().system();
            assertThat(simulation.scene().diaphragm().relativeSize()).isEqualTo(1);
            for (int i = 0; i < system.nodeCount(); i++) {
                assertThat(system.viscosities()[i]).isCloseTo(rate * system.masses()[i], withPercentage(1e-9));
            }
        }
    }
}
