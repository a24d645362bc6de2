package org.phrenic.anatomy.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

/** Dents in a flat sheet of triangles: how far they reach and how smooth they are. */
class YieldSpreadTest {
    private static final int SIDE = 41;
    private static final int MIDDLE = SIDE / 2 * SIDE + SIDE / 2;

    /** A square of unit cells, two triangles each. */
    private static TriangleMesh square() {
        return Shapes.sheet(SIDE - 1, SIDE - 1, SIDE, SIDE);
    }

    private static double[] pushed(double[] before, int... vertices) {
        double[] after = before.clone();
        for (int v : vertices) {
            after[3 * v + 2] = -10;
        }
        return after;
    }

    @Test
    void oneVertexTakesThoseAboutItAlongLessTheFartherTheyAre() {
        TriangleMesh square = square();
        double[] after = pushed(square.positions(), MIDDLE);
        assertThat(new YieldSpread(square).spread(square.positions(), after)).isTrue();
        for (int far = 0; far < 8; far++) {
            assertThat(after[3 * (MIDDLE + far) + 2])
                    .as("%s edges away", far)
                    .isNegative()
                    .isLessThan(after[3 * (MIDDLE + far + 1) + 2]);
            assertThat(after[3 * (MIDDLE + far) + 2])
                    .as("alike on both sides, %s edges away", far)
                    .isCloseTo(after[3 * (MIDDLE - far) + 2], within(1e-12));
        }
        for (int beyond = 9; beyond <= SIDE / 2; beyond++) {
            assertThat(after[3 * (MIDDLE + beyond) + 2])
                    .as("%s edges away", beyond)
                    .isZero();
        }
        for (int i = 0; i < after.length; i++) {
            assertThat(i % 3 == 2 || after[i] == square.positions()[i])
                    .as("coordinate %s along the square", i)
                    .isTrue();
        }
    }

    /** In a tetrahedron each vertex has the three others as neighbours, so that two numbers tell all displacements. */
    @Test
    void aPushedCornerOfATetrahedronMovesByEightSweepsOfTheLaw() {
        double[] corners = {0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10};
        double[] push = {1, -2, -10};
        double[] after = corners.clone();
        for (int axis = 0; axis < 3; axis++) {
            after[axis] += push[axis];
        }
        new YieldSpread(new TriangleMesh(corners, new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}))
                .spread(corners, after);
        double pushed = 1;
        double other = 0;
        for (int sweep = 0; sweep < 8; sweep++) {
            double now = (1 + 3 * other) / (1 + 3 + 0.1);
            other = (pushed + 2 * other) / (3 + 0.1);
            pushed = now;
        }
        for (int i = 0; i < after.length; i++) {
            assertThat(after[i] - corners[i])
                    .as("coordinate %s", i)
                    .isCloseTo((i < 3 ? pushed : other) * push[i % 3], within(1e-12));
        }
    }

    @Test
    void neighboursThatYieldByTurnsBecomeADentWithoutSteps() {
        TriangleMesh square = square();
        double[] p = square.positions();
        double[] after = p.clone();
        for (int row = 10; row < 30; row++) {
            for (int column = 10; column < 30; column++) {
                after[3 * (row * SIDE + column) + 2] = (row + column) % 2 == 0 ? -10 : 0;
            }
        }
        new YieldSpread(square).spread(p, after);
        double least = 0;
        double most = -10;
        for (int row = 15; row < 25; row++) {
            for (int column = 15; column < 25; column++) {
                double z = after[3 * (row * SIDE + column) + 2];
                least = Math.min(least, z);
                most = Math.max(most, z);
            }
        }
        // Steps of 10 before.
        assertThat(most - least).as("step within the dent").isLessThan(1);
        assertThat(least).isLessThan(-3);
    }

    @Test
    void anOrganThatDoesNotYieldIsLeftAloneAndOneThatDoesIsSpreadAlikeEveryTime() {
        TriangleMesh square = square();
        double[] p = square.positions();
        YieldSpread spread = new YieldSpread(square);
        double[] same = p.clone();
        assertThat(spread.spread(p, same)).isFalse();
        assertThat(same).isEqualTo(p);
        double[] first = pushed(p, MIDDLE, MIDDLE + 3);
        spread.spread(p, first);
        spread.spread(p, pushed(p, MIDDLE - 7));
        double[] second = pushed(p, MIDDLE, MIDDLE + 3);
        spread.spread(p, second);
        assertThat(second).isEqualTo(first);
    }
}
