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
