package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Distances from a reference on the coarse virtual adult male: at rest against itself, and in a breath against where it
 * was.
 */
class DistanceFieldTest {
    /** Frames hold float coordinates of about 1000 mm. */
    private static final float FLOAT_MM = 1e-3f;

    private static ScenePlayer player;

    @BeforeAll
    static void load() {
        player = new ScenePlayer(
                Scenario.defaults().with("resolution=low", "lungs=off", "sternum=kinematic"), (at, of, rate) -> {});
    }

    @AfterAll
    static void close() {
        player.close();
    }

    @Test
    void aSurfaceIsNowhereAwayFromItselfAndNeverFartherThanItMoved() {
        Surface diaphragm = player.surfaces().get(0);
        DistanceField itself = new DistanceField(diaphragm.rest());
        Frame frame = player.advanceTo(0);
        for (float distance : itself.distances(diaphragm, 0, frame)) {
            assertThat(distance).isCloseTo(0, within(FLOAT_MM));
        }
        frame = player.advanceTo(0.6);
        float[] distances = itself.distances(diaphragm, 0, frame);
        float[] now = frame.positions(0);
        float farthest = 0;
        for (int i = 0; i < distances.length; i++) {
            double moved = Math.sqrt(square(now[3 * i] - diaphragm.rest().x(i))
                    + square(now[3 * i + 1] - diaphragm.rest().y(i))
                    + square(now[3 * i + 2] - diaphragm.rest().z(i)));
            assertThat(distances[i]).isLessThanOrEqualTo((float) moved + FLOAT_MM);
            farthest = Math.max(farthest, distances[i]);
        }
        assertThat(farthest).isGreaterThan(0.5f);
    }

    @Test
    void whatStandsStillIsAsFarAsItsShiftedTwin() {
        int spine = 0;
        while (player.surfaces().get(spine).motion() != Surface.Motion.STILL) {
            spine++;
        }
        Surface vertebra = player.surfaces().get(spine);
        double[] box = vertebra.rest().bounds();
        double below = box[2] - 10;
        TriangleMesh floor = new TriangleMesh(
                new double[] {-1e4, -1e4, below, 1e4, -1e4, below, 0, 2e4, below}, new int[] {0, 1, 2});
        float[] distances = new DistanceField(floor).distances(vertebra, spine, player.advanceTo(0.7));
        for (int i = 0; i < distances.length; i++) {
            assertThat(distances[i]).isCloseTo((float) (vertebra.rest().z(i) - below), within(FLOAT_MM));
        }
    }

    private static double square(double value) {
        return value * value;
    }
}
