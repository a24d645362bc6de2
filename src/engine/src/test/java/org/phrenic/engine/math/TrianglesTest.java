package org.phrenic.engine.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TrianglesTest {
    /**
     * Vertex 0 is of no triangle; 1 to 3 are a right angle with legs of 3 and 4 in a plane across z, seen from above
     * anticlockwise.
     */
    private static final double[] P = {9, 9, 9, 1, 1, 5, 4, 1, 5, 1, 5, 5};

    @Test
    void theCrossProductStandsOnTheTriangleAndIsTwiceItsAreaLong() {
        double[] cross = new double[3];
        assertThat(Triangles.cross(P, 3, 6, 9, cross)).isEqualTo(12);
        assertThat(cross).containsExactly(0, 0, 12);
        assertThat(Triangles.cross(P, 3, 9, 6, cross)).isEqualTo(12);
        assertThat(cross).as("seen from below").containsExactly(0, 0, -12);
    }

    @Test
    void theNormalIsOfUnitLengthAndZeroWithoutArea() {
        double[] normal = new double[3];
        assertThat(Triangles.normal(P, 3, 6, 9, normal)).isEqualTo(12);
        assertThat(normal).containsExactly(0, 0, 1);
        assertThat(Triangles.normal(P, 3, 6, 6, normal)).isZero();
        assertThat(normal).containsExactly(0, 0, 0);
    }
}
