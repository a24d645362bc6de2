package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.model.organ.LungPart;

/** Lungs that leave the chest are noticed, although they are neither fast nor, in the paper's material, bounded. */
class LungsLeaveTheChestTest {
    private static final int STEPS = 40;

    private static void step(Simulation simulation) {
        for (int i = 0; i < STEPS; i++) {
            simulation.step();
        }
    }

    @Test
    void aLungDrawnOutOfTheNeckIsNoticedAndTheLastGoodStateIsBack() {
        try (Simulation simulation = Runs.simulation(Runs.scenario("material=paper", "sternum=off"))) {
            step(simulation);
            long before = simulation.steps();
            LungPart lungs = simulation.scene().lungs().orElseThrow();
            double[] rest = simulation.scene().restPositions();
            int first = lungs.firstNodes.get(0);
            int top = first;
            for (int i = first; i < first + lungs.structures.get(0).mesh().vertexCount(); i++) {
                top = rest[3 * i + 2] > rest[3 * top + 2] ? i : top;
            }
            // Every node of the top goes up by 120 mm, as in a spike out of the neck; none is fast.
            int count = 0;
            for (int i = first; i < first + lungs.structures.get(0).mesh().vertexCount(); i++) {
                if (rest[3 * i + 2] > rest[3 * top + 2] - 20) {
                    simulation.system()
                            .positions()[3 * simulation.system().layout().internal(i) + 2] += 120;
                    count++;
                }
            }
            assertThat(count).isPositive();
            DivergenceException noticed = catchThrowableOfType(DivergenceException.class, () -> step(simulation));
            assertThat(noticed).hasMessageContaining("lung_").hasMessageContaining("is outside the chest");
            assertThat(simulation.steps()).isLessThanOrEqualTo(before);
            double[] now = new double[rest.length];
            simulation.system().layout().toCaller(simulation.system().positions(), now);
            assertThat(now[3 * top + 2]).isLessThan(rest[3 * top + 2] + 10);
        }
    }
}
