package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/** A ball of 20 mm below the virtual man's right dome, whose nodes are lowered: its top is 10 mm through the sheet. */
class YieldingOrganTest {
    private static final double RADIUS_MM = 20;
    private static final double LOWERED_MM = 14;
    private static Simulation simulation;

    @BeforeAll
    static void load() {
        Scenario scenario = Scenario.defaults().with("resolution=low").with("lungs=off");
        simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario));
    }

    @AfterAll
    static void close() {
        simulation.close();
    }

    private static TriangleMesh ball() {
        TriangleMesh liver = simulation
                .scene()
                .thorax()
                .structuresOf(StructureKind.LIVER)
                .get(0)
                .mesh();
        double[] p = liver.positions().clone();
        double[] box = liver.bounds();
        double[] place = {-68, -16, 111 - RADIUS_MM};
        for (int k = 0; k < p.length; k += 3) {
            double[] d = new double[3];
            double length = 0;
            for (int axis = 0; axis < 3; axis++) {
                d[axis] = p[k + axis] - (box[axis] + box[3 + axis]) / 2;
                length += d[axis] * d[axis];
            }
            for (int axis = 0; axis < 3; axis++) {
                p[k + axis] = place[axis] + RADIUS_MM * d[axis] / Math.sqrt(length);
            }
        }
        return liver.withPositions(p);
    }

    private static TriangleMesh lowered(SheetContact contact, String name, double mm) {
        contact.update(simulation.scene().restPositions());
        TriangleMesh ball = ball();
        YieldingOrgan organ =
                new YieldingOrgan(contact, new Structure(name, StructureKind.ORGAN, 0, Side.MIDLINE, ball), false);
        double[] nodes = simulation.scene().restPositions().clone();
        for (int k = 2; k < nodes.length; k += 3) {
            nodes[k] -= mm;
        }
        contact.update(nodes);
        return ball.withPositions(organ.at(ball.positions()).clone());
    }

    @Test
    void aKidneyIsShiftedAndKeepsItsShape() {
        SheetContact contact = new SheetContact(simulation.scene().diaphragm());
        double full = MeshMeasure.signedVolume(ball());
        TriangleMesh kidney = lowered(contact, "kidney_L", LOWERED_MM);
        TriangleMesh spleen = lowered(contact, "spleen", LOWERED_MM);
        double top = ball().bounds()[5];
        assertThat(kidney.bounds()[5]).as("top, mm").isCloseTo(spleen.bounds()[5], within(1.0));
        assertThat(top - kidney.bounds()[5]).as("yields, mm").isBetween(6.0, 12.0);
        // A spleen's lower end stays where it is.
        assertThat(spleen.bounds()[2]).isEqualTo(ball().bounds()[2]);
        assertThat(ball().bounds()[2] - kidney.bounds()[2]).as("shift, mm").isGreaterThan(5);
        assertThat(Math.abs(MeshMeasure.signedVolume(kidney) / full - 1)).isLessThan(0.03);
        assertThat(Math.abs(MeshMeasure.signedVolume(spleen) / full - 1)).isGreaterThan(0.08);
    }

    @Test
    void whatDoesNotTouchStays() {
        SheetContact contact = new SheetContact(simulation.scene().diaphragm());
        assertThat(lowered(contact, "kidney_L", 0).positions()).containsExactly(ball().positions());
        assertThat(lowered(contact, "kidney_L", -5).positions()).containsExactly(ball().positions());
    }

    /** The shift goes with the sheet without jumps. */
    @Test
    void aKidneyMovesSteadily() {
        SheetContact contact = new SheetContact(simulation.scene().diaphragm());
        double last = lowered(contact, "kidney_L", 0).bounds()[2];
        for (double mm = 0.5; mm <= LOWERED_MM; mm += 0.5) {
            double next = lowered(contact, "kidney_L", mm).bounds()[2];
            assertThat(last - next).as("at " + mm).isBetween(-0.2, 1.2);
            last = next;
        }
    }
}
