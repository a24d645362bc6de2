package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

class TissueMassTest {
    /** The force on a node of mass m and velocity v is -γ v; in a sheet of usual size γ / m is the rate, 1/s. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 5, 40})
    void dampingOverMassIsTheRateOfTheScenario(double rate) {
        try (Simulation simulation =
                Simulation.of(Runs.scenario(Runs.sheetAlone("damping_rate_per_s=" + rate)), Runs.male())) {
            ParticleSystem system = simulation.scene().system();
            assertThat(simulation.scene().diaphragm().relativeSize()).isEqualTo(1);
            for (int i = 0; i < system.nodeCount(); i++) {
                assertThat(system.viscosities()[i]).isCloseTo(rate * system.masses()[i], withPercentage(1e-9));
            }
        }
    }
}
