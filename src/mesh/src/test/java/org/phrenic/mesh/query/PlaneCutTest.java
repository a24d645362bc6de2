package org.phrenic.mesh.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

/** A cube of side 2 about the origin, cut at places where the cut is known. */
class PlaneCutTest {
    private static final double EXACT = 1e-12;
    private static final double[] CUBE = {
        -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1
    };
    private static final int[] FACES = {
        0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7
    };

    private static PlaneCut level(double z) {
        return new PlaneCut(new double[] {0, 0, z}, new double[] {1, 0, 0}, new double[] {0, 1, 0});
    }

    /** Twice the area within a closed curve. */
    private static double twiceArea(double[] curve) {
        double sum = 0;
        for (int i = 0; i + 3 < curve.length; i += 2) {
            sum += curve[i] * curve[i + 3] - curve[i + 2] * curve[i + 1];
        }
        return Math.abs(sum);
    }

    @Test
    void aPlaneThroughACubeCutsAClosedSquare() {
        List<double[]> curves = level(0.3).intersect(CUBE, FACES);
        assertThat(curves).hasSize(1);
        double[] curve = curves.get(0);
        assertThat(curve[0]).isEqualTo(curve[curve.length - 2]);
        assertThat(curve[1]).isEqualTo(curve[curve.length - 1]);
        assertThat(twiceArea(curve)).isCloseTo(8, within(EXACT));
    }

    @Test
    void aPlaneThroughVerticesCutsOnce() {
        double h = Math.sqrt(0.5);
        PlaneCut diagonal = new PlaneCut(new double[3], new double[] {h, h, 0}, new double[] {0, 0, 1});
        List<double[]> curves = diagonal.intersect(CUBE, FACES);
        assertThat(curves).hasSize(1);
        // A rectangle of sides 2 and 2 sqrt 2.
        assertThat(twiceArea(curves.get(0))).isCloseTo(8 * Math.sqrt(2), within(EXACT));
    }

    /**
     * A box of 2 x 2 x 4 mm cut at y = -0.4, seen from behind: the first axis points up, the second to the left (z and
     * x), so that the first x second axis is y. The origin is at x = 0.2, z = 0.3.
     */
    @Test
    void aCurveIsInTheCoordinatesOfThePlane() {
        PlaneCut plane = new PlaneCut(new double[] {0.2, -0.4, 0.3}, new double[] {0, 0, 1}, new double[] {1, 0, 0});
        double[] box = CUBE.clone();
        for (int i = 2; i < box.length; i += 3) {
            box[i] *= 2;
        }
        double[] curve = plane.intersect(box, FACES).get(0);
        double[] range = {curve[0], curve[1], curve[0], curve[1]};
        double turned = 0;
        for (int i = 0; i + 3 < curve.length; i += 2) {
            turned += curve[i] * curve[i + 3] - curve[i + 2] * curve[i + 1];
            for (int axis = 0; axis < 2; axis++) {
                range[axis] = Math.min(range[axis], curve[i + axis]);
                range[2 + axis] = Math.max(range[2 + axis], curve[i + axis]);
            }
        }
        // Heights of -2 to 2 less 0.3, places of -1 to 1 less 0.2; a curve of 4 x 2 mm.
        assertThat(range).containsExactly(new double[] {-2.3, -1.2, 1.7, 0.8}, within(EXACT));
        assertThat(turned / 2).as("clockwise about the normal").isCloseTo(-8, within(EXACT));
        assertThat(plane.project(new double[] {1, 7, 2})).containsExactly(new double[] {1.7, 0.8}, within(EXACT));
        assertThat(plane.signedDistance(new double[] {3, 1, 5})).isCloseTo(1.4, within(EXACT));
    }

    @Test
    void anOpenMeshGivesOneOpenCurve() {
        int[] open = java.util.Arrays.copyOf(FACES, FACES.length - 6);
        List<double[]> curves = level(0.3).intersect(CUBE, open);
        assertThat(curves).hasSize(1);
        double[] curve = curves.get(0);
        assertThat(Math.hypot(curve[0] - curve[curve.length - 2], curve[1] - curve[curve.length - 1]))
                .isCloseTo(2, within(EXACT));
    }

    @Test
    void aPlaneBesideTheMeshCutsNothing() {
        assertThat(level(1.5).intersect(CUBE, FACES)).isEmpty();
    }
}
