package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.SceneObserver;

/** How liver and base of the lungs go with a diaphragm that is moved by hand. */
class OrgansFollowTest {
    private static final double ROUNDING = 1e-6;
    /**
     * Between the shape as meshed, where tracks begin, and the shape as settled; what settling opens counts by the
     * square of 1 over 15 mm (LungBase).
     */
    private static final double SETTLED_MM = 4;

    private static Simulation simulation;
    private static Scene scene;

    @BeforeAll
    static void make() {
        simulation = Runs.simulation(Runs.scenario("sternum=kinematic"));
        scene = simulation.scene();
    }

    @AfterAll
    static void end() {
        simulation.close();
    }

    private static double[] liver(double[] now) {
        return scene.liver().orElseThrow().positions(scene.restPositions(), now).clone();
    }

    private static int vertex(double[] p, int axis, boolean most) {
        return IntStream.range(0, p.length / 3)
                .boxed()
                .max((a, b) -> (most ? 1 : -1) * Double.compare(p[3 * a + axis], p[3 * b + axis]))
                .orElseThrow();
    }

    @Test
    void theLiverGoesWithTheRoofAndLessSoAtItsLowerEdge() {
        double[] rest = liver(scene.restPositions());
        double[] now = scene.restPositions().clone();
        for (int i = 0; i < now.length; i++) {
            now[i] += new double[] {1, 3, -14}[i % 3];
        }
        double[] moved = liver(now);
        int top = 3 * vertex(rest, 2, true);
        int edge = 3 * vertex(rest, 2, false);
        assertThat(moved[top] - rest[top]).isCloseTo(1, within(ROUNDING));
        assertThat(moved[edge + 1] - rest[edge + 1]).isCloseTo(3, within(ROUNDING));
        assertThat(moved[top + 2] - rest[top + 2]).isCloseTo(-14, within(ROUNDING));
        assertThat(moved[edge + 2] - rest[edge + 2]).isBetween(-0.9 * 14, -0.6 * 14);
    }

    /** The lower right lobe goes 0.6 to 0.7 times as far as the dome (doi 10.1002/jmri.22418, 10 people). */
    @Test
    void inAQuietBreathTheLowerEdgeOfTheLiverGoesTwoThirdsAsFarAsTheDome() {
        try (Simulation breath = Runs.simulation(Runs.scenario(Runs.sheetAlone()))) {
            while (breath.time() < QuietBreathTest.INSPIRATION_S) {
                breath.step();
            }
            Scene breathing = breath.scene();
            LiverPart part = breathing.liver().orElseThrow();
            double[] rest = part.positions(breathing.restPositions(), breathing.restPositions())
                    .clone();
            double[] now = new double[breathing.restPositions().length];
            breathing.layout().toCaller(breathing.system().positions(), now);
            double[] moved = part.positions(breathing.restPositions(), now);
            double dome = new SceneObserver(breathing).observe(breath.time()).get("dome_right_mm");
            assertThat(lowestFifth(rest, moved) / dome).isBetween(0.6, 0.7);
        }
    }

    /** Mean vertical displacement of the lowest fifth of the vertices, mm. */
    private static double lowestFifth(double[] rest, double[] moved) {
        int[] order = IntStream.range(0, rest.length / 3)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> rest[3 * i + 2]))
                .limit(rest.length / 15)
                .mapToInt(i -> 3 * i + 2)
                .toArray();
        return IntStream.of(order)
                .mapToDouble(i -> moved[i] - rest[i])
                .average()
                .orElseThrow();
    }

    /** Axes of LPS: to the left, to the back, up. */
    @Test
    void theObservablesOfTheLiverGoWithTheBodysAxes() {
        double[] x = scene.system().positions();
        double[] before = x.clone();
        for (int i = 0; i < x.length; i++) {
            x[i] += new double[] {1, 3, -14}[i % 3];
        }
        Observation seen = new SceneObserver(scene).observe(0);
        System.arraycopy(before, 0, x, 0, x.length);
        assertThat(seen.get("liver_lr_mm")).as("to the left").isCloseTo(1, within(ROUNDING));
        assertThat(seen.get("liver_ap_mm")).as("to the back").isCloseTo(3, within(ROUNDING));
        assertThat(seen.get("liver_si_mm")).as("up").isBetween(-14.0, -0.82 * 14);
    }

    @Test
    void theLiverTurnsAsTheRoofDoesButLess() {
        double[] rest = liver(scene.restPositions());
        double[] now = scene.restPositions().clone();
        double angle = 0.1;
        // Its back goes down: about the axis to the right.
        HelicalAxis.through(new double[] {-1, 0, 0}, new double[] {0, 0, 60}, angle, 0)
                .motion()
                .apply(now);
        double[] moved = liver(now);
        int top = vertex(rest, 2, true);
        int edge = vertex(rest, 2, false);
        double turned = ((moved[3 * top + 1] - moved[3 * edge + 1]) - (rest[3 * top + 1] - rest[3 * edge + 1]))
                / (rest[3 * top + 2] - rest[3 * edge + 2]);
        assertThat(turned).isBetween(0.3 * angle, angle);
    }

    @Test
    void theBorderOfTheLungComesDownAsTheSheetLeavesTheWallAndGoesBackWithIt() {
        Attachments base = scene.lungBase().orElseThrow();
        int[] nodes = base.callerNodes();
        double[] atRest = base.anchorsAt(0);
        for (int i = 0; i < atRest.length; i++) {
            assertThat(atRest[i]).isCloseTo(scene.restPositions()[3 * nodes[i / 3] + i % 3], within(SETTLED_MM));
        }
        double[] x = scene.system().positions();
        double[] before = x.clone();
        DiaphragmPart part = scene.diaphragm();
        for (int v = 0; v < part.diaphragm.sheet().vertexCount(); v++) {
            int node = 3 * scene.system().layout().internal(part.firstNode + v);
            x[node] *= 0.75;
        }
        double[] opened = base.anchorsAt(0);
        System.arraycopy(before, 0, x, 0, x.length);
        double lowest = Arrays.stream(part.insertedVertices())
                .mapToDouble(v -> part.diaphragm.sheet().z(v))
                .min()
                .orElseThrow();
        double most = 0;
        for (int i = 2; i < opened.length; i += 3) {
            assertThat(opened[i]).isGreaterThan(lowest - SETTLED_MM);
            most = Math.max(most, atRest[i] - opened[i]);
        }
        // The zone of apposition of this body is some 90 mm high at the side and more behind; its insertion bounds the
        // way, above.
        assertThat(most).isGreaterThan(60);
        assertThat(base.anchorsAt(0)).containsExactly(atRest, within(ROUNDING));
    }
}
