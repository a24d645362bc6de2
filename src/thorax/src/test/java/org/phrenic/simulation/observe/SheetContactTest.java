package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.DiaphragmSide;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/** Organs about the virtual man's diaphragm, whose nodes are all lowered by 20 mm; its right dome is at z = 116 mm. */
class SheetContactTest {
    private static final double LOWERED_MM = 20;
    private static Simulation simulation;
    private static double[] lowered;

    @BeforeAll
    static void lowerTheDiaphragm() {
        Scenario scenario = Scenario.defaults().with("resolution=low").with("lungs=off");
        simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario));
        lowered = simulation.scene().restPositions().clone();
        for (int k = 2; k < lowered.length; k += 3) {
            lowered[k] -= LOWERED_MM;
        }
    }

    @AfterAll
    static void close() {
        simulation.close();
    }

    /** A liver that stands still is 20 mm through the lowered dome: its top yields to 2 mm, its lower part stays. */
    @Test
    void organsYieldToTheFaceOfTheirSideAlone() {
        SheetContact contact = new SheetContact(simulation.scene().diaphragm());
        contact.update(lowered);
        double[] liver = {-68, -16, 108, -68, -16, 60};
        contact.pushBack(liver, false);
        // The abdominal face lies at about 115 - 20 mm here.
        assertThat(liver[2]).isCloseTo(97, within(1.0));
        assertThat(liver[5]).isEqualTo(60);
        double[] lung = {-68, -16, 100, -68, -16, 85};
        contact.pushBack(lung, true);
        assertThat(lung[2]).isEqualTo(100);
        // The thoracic face lies at about 116 - 20 mm.
        assertThat(lung[5]).isCloseTo(94, within(1.0));
        contact.update(simulation.scene().restPositions());
        double[] atRest = {-68, -16, 108};
        contact.pushBack(atRest, false);
        assertThat(atRest).containsExactly(-68, -16, 108);
    }

    @Test
    void sidesAreToldByName() {
        assertThat(DiaphragmSide.of(StructureKind.ORGAN, "kidney_L")).isEqualTo(DiaphragmSide.BELOW);
        assertThat(DiaphragmSide.of(StructureKind.ORGAN, "heart")).isEqualTo(DiaphragmSide.ABOVE);
        assertThat(DiaphragmSide.of(StructureKind.LUNG, "lung_R_middle")).isEqualTo(DiaphragmSide.ABOVE);
        assertThat(DiaphragmSide.of(StructureKind.VESSEL, "aorta")).isEqualTo(DiaphragmSide.NEITHER);
    }
}
