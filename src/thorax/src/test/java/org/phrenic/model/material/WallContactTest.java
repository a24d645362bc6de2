package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.SlidingSheet;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

class WallContactTest {
    private static final int STEPS = 240;
    private static final int EVERY = 8;

    /**
     * Without damping nothing but contact holds a vertex at the wall. Planes are taken anew every 20 ms, in which the
     * wall moves by a few tenths of a millimetre. A vertex of the crura within 25 mm of the line about which the wall
     * is a radius would find a plane 6 mm away.
     */
    @ParameterizedTest
    @ValueSource(strings = {"virtual/adult-male", "virtual/adult-female"})
    void theSheetStaysInsideTheWallWithoutDamping(String body) {
        Scenario scenario = Scenario.defaults()
                .with("anatomy=" + body, "resolution=low", "lungs=embedded", "sternum=kinematic", "liver=false")
                .with("damping_rate_per_s=0");
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario))) {
            Scene scene = simulation.scene();
            SlidingSheet sheet = scene.slidingSheet();
            int[] nodes = MassSpringBuilder.offset(sheet.vertices(), scene.diaphragm().firstNode);
            SlidingContact measure = new SlidingContact(scene.layout(), nodes, sheet.wall(), 0);
            double greatest = 0;
            for (int step = 1; step <= STEPS; step++) {
                simulation.step();
                if (step % EVERY == 0) {
                    measure.invalidate();
                    measure.prepare(scene.system(), simulation.time());
                    greatest = Math.max(greatest, measure.error(scene.system()));
                }
            }
            assertThat(greatest).as("distance outside the wall, mm").isLessThan(0.5);
        }
    }
}
