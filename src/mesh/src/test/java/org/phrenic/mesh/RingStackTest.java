package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Volumes are those of the polyhedra; a negative one would say that the normals point inward. */
class RingStackTest {
    /** A regular polygon of n sides in the unit circle. */
    private static double polygonArea(int n) {
        return 0.5 * n * Math.sin(2 * Math.PI / n);
    }

    @Test
    void aCylinderHoldsItsBaseTimesItsHeight() {
        TriangleMesh cylinder = RingStack.revolution(24, -1, 3, -1, 1, 3, 1);
        assertThat(MeshMeasure.signedVolume(cylinder)).isCloseTo(4 * polygonArea(24), within(1e-12));
    }

    @Test
    void aBallIsAStackOfFrustaBetweenCones() {
        int n = 32;
        double expected = 0;
        for (int i = 0; i < n / 2; i++) {
            double from = 2 * Math.PI * i / n;
            double to = 2 * Math.PI * (i + 1) / n;
            double a = Math.sin(from);
            double b = Math.sin(to);
            expected += (Math.cos(from) - Math.cos(to)) * (a * a + a * b + b * b) / 3 * polygonArea(n);
        }
        TriangleMesh ball = RingStack.unitBall(n);
        assertThat(MeshMeasure.signedVolume(ball)).isCloseTo(expected, within(1e-12));
        assertThat(MeshMeasure.openness(ball)).isLessThan(1e-14);
    }
}
