package org.phrenic.mesh.edit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SelfIntersections;

class SelfIntersectionSmoothingTest {
    private static final int SIDE = 12;

    /** A square grid of 12 x 12 cells of 1 mm; a vertex at (column, row) has the index column + 13 row. */
    private static TriangleMesh grid() {
        double[] p = new double[3 * (SIDE + 1) * (SIDE + 1)];
        int[] t = new int[6 * SIDE * SIDE];
        for (int row = 0; row <= SIDE; row++) {
            for (int column = 0; column <= SIDE; column++) {
                int v = column + (SIDE + 1) * row;
                p[3 * v] = column;
                p[3 * v + 1] = row;
            }
        }
        for (int cell = 0; cell < SIDE * SIDE; cell++) {
            int v = cell % SIDE + (SIDE + 1) * (cell / SIDE);
            int[] corners = {v, v + 1, v + SIDE + 2, v, v + SIDE + 2, v + SIDE + 1};
            System.arraycopy(corners, 0, t, 6 * cell, 6);
        }
        return new TriangleMesh(p, t);
    }

    /** One vertex is pulled down through the middle of a triangle three cells away. */
    @Test
    void whatCrossesIsSmoothedUntilNothingDoes() {
        TriangleMesh flat = grid();
        double[] p = flat.positions().clone();
        int pulled = 6 + (SIDE + 1) * 6;
        p[3 * pulled] += 3.4;
        p[3 * pulled + 1] += 0.2;
        p[3 * pulled + 2] = -0.5;
        for (int v = pulled + 1; v <= pulled + 3; v++) {
            p[3 * v + 2] = 0.5;
        }
        TriangleMesh crossed = flat.withPositions(p);
        assertThat(SelfIntersections.count(crossed)).isPositive();
        TriangleMesh smoothed = SelfIntersectionSmoothing.smooth(crossed);
        assertThat(SelfIntersections.count(smoothed)).isZero();
        // The corner of the grid is far from what crosses and keeps its place.
        assertThat(smoothed.x(0)).isEqualTo(crossed.x(0));
        assertThat(smoothed.y(0)).isEqualTo(crossed.y(0));
        assertThat(smoothed.x(pulled)).isBetween(6.0, 9.0);
    }

    @Test
    void aSurfaceThatDoesNotCrossItselfIsReturnedAsItIs() {
        TriangleMesh flat = grid();
        assertThat(SelfIntersectionSmoothing.smooth(flat)).isSameAs(flat);
    }
}
