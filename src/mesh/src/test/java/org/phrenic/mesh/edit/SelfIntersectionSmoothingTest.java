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

    /** The grid folded along its middle column to a narrow ridge: at depth d its sides are 0.3 d apart. */
    private static TriangleMesh ridge() {
        TriangleMesh flat = grid();
        double[] p = flat.positions().clone();
        for (int v = 0; v < flat.vertexCount(); v++) {
            double fromRidge = flat.x(v) - SIDE / 2.0;
            p[3 * v] = 0.15 * fromRidge;
            p[3 * v + 2] = -Math.abs(fromRidge);
        }
        return flat.withPositions(p);
    }

    /** A vertex of the left side of a ridge, 2 mm below its crest, is pushed through the right side. */
    @Test
    void whatCrossesIsSmoothedUntilNothingDoes() {
        TriangleMesh ridge = ridge();
        assertThat(SelfIntersections.count(ridge)).isZero();
        double[] p = ridge.positions().clone();
        int pushed = 4 + (SIDE + 1) * 6;
        p[3 * pushed] = 0.6;
        TriangleMesh crossed = ridge.withPositions(p);
        assertThat(SelfIntersections.count(crossed)).isPositive();
        TriangleMesh smoothed = SelfIntersectionSmoothing.smooth(crossed);
        assertThat(SelfIntersections.count(smoothed)).isZero();
        assertThat(smoothed.x(pushed)).isLessThan(0.3);
        // A corner of the grid is far from what crosses and keeps its place.
        assertThat(smoothed.x(0)).isEqualTo(crossed.x(0));
        assertThat(smoothed.z(0)).isEqualTo(crossed.z(0));
    }

    @Test
    void aSurfaceThatDoesNotCrossItselfIsReturnedAsItIs() {
        TriangleMesh flat = grid();
        assertThat(SelfIntersectionSmoothing.smooth(flat)).isSameAs(flat);
    }
}
