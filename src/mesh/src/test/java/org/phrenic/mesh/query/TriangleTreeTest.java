package org.phrenic.mesh.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class TriangleTreeTest {
    private static final double ROUNDING = 1e-9;

    @Property(tries = 60, seed = "1")
    void theNearestPointIsTheOneThatASearchOfAllTrianglesFinds(@ForAll @IntRange(min = 0, max = 100000) int seed) {
        Random random = new Random(seed);
        TriangleMesh mesh = soupWithDegenerates(random, 1 + random.nextInt(200));
        TriangleTree tree = new TriangleTree(mesh);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int i = 0; i < 20; i++) {
            double[] q = {30 * random.nextDouble() - 10, 30 * random.nextDouble() - 10, 30 * random.nextDouble() - 10};
            double expected = Double.POSITIVE_INFINITY;
            for (int t = 0; t < mesh.triangleCount(); t++) {
                expected = Math.min(expected, distanceByRefinement(mesh, t, q));
            }
            assertThat(tree.closest(q[0], q[1], q[2], hit)).isTrue();
            assertThat(Math.sqrt(hit.distanceSquared)).isCloseTo(expected, within(ROUNDING));
            double toPoint =
                    Math.sqrt(Math.pow(hit.x - q[0], 2) + Math.pow(hit.y - q[1], 2) + Math.pow(hit.z - q[2], 2));
            assertThat(toPoint).isCloseTo(expected, within(ROUNDING));
            assertThat(hit.weightA + hit.weightB + hit.weightC).isCloseTo(1, within(ROUNDING));
            assertThat(tree.closest(q[0], q[1], q[2], expected * 0.999, hit)).isFalse();
            assertThat(hit.triangle).isEqualTo(-1);
            assertThat(tree.closest(q[0], q[1], q[2], expected * 1.001 + ROUNDING, hit))
                    .isTrue();
            assertThat(tree.isWithin(q[0], q[1], q[2], expected * 0.999, hit)).isFalse();
            assertThat(tree.isWithin(q[0], q[1], q[2], expected * 1.001 + ROUNDING, hit))
                    .isTrue();
        }
    }

    /** To the last bit, because frames of different runs are compared. */
    @Property(tries = 30, seed = "1")
    void theAnswerDoesNotDependOnTheGuess(@ForAll @IntRange(min = 0, max = 100000) int seed) {
        Random random = new Random(seed);
        TriangleMesh mesh = soupWithDegenerates(random, 2 + random.nextInt(200));
        boolean[] among = new boolean[mesh.triangleCount()];
        for (int t = 0; t < among.length; t++) {
            among[t] = random.nextBoolean();
        }
        among[0] = true;
        TriangleTree tree = new TriangleTree(mesh);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        TriangleTree.Hit guessed = new TriangleTree.Hit();
        for (int i = 0; i < 20; i++) {
            double x = 30 * random.nextDouble() - 10;
            double y = 30 * random.nextDouble() - 10;
            double z = 30 * random.nextDouble() - 10;
            tree.closest(x, y, z, hit);
            assertThat(tree.closest(x, y, z, 100, random.nextInt(among.length), null, guessed))
                    .isTrue();
            assertThat(guessed.triangle).isEqualTo(hit.triangle);
            assertThat(new double[] {guessed.x, guessed.y, guessed.z}).containsExactly(hit.x, hit.y, hit.z);
            tree.closest(x, y, z, 100, -1, among, hit);
            assertThat(among[hit.triangle]).isTrue();
            tree.closest(x, y, z, 100, random.nextInt(among.length), among, guessed);
            assertThat(guessed.triangle).isEqualTo(hit.triangle);
            assertThat(tree.closest(x, y, z, 0.999 * Math.sqrt(hit.distanceSquared), -1, among, guessed))
                    .isFalse();
        }
    }

    @Test
    void withANormalTheSearchKeepsToOneSideOfAThinSheet() {
        TriangleMesh slab = Shapes.box(100, 100, 2);
        TriangleTree tree = new TriangleTree(slab);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(50, 50, 0.5, hit);
        assertThat(hit.z).isCloseTo(0, within(ROUNDING));
        assertThat(tree.closest(50, 50, 0.5, 10, 0, 0, 1, 0.5, hit)).isTrue();
        assertThat(hit.z).isCloseTo(2, within(ROUNDING));
        assertThat(hit.distanceSquared).isCloseTo(2.25, within(ROUNDING));
        assertThat(tree.closest(50, 50, 0.5, 1, 0, 0, 1, 0.5, hit)).isFalse();
    }

    @Test
    void aPointOutsideASphereIsItsDistanceFromTheCentreLessTheRadiusAway() {
        TriangleTree tree = new TriangleTree(Shapes.sphere(10, 5));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(0, 30, 40, hit);
        // 10 * 4^5 + 2 vertices with edges of at most 0.4 mm: the middle of a triangle lies at most 0.4^2 / (6 * 10) mm
        // below the sphere.
        assertThat(Math.sqrt(hit.distanceSquared)).isCloseTo(40, within(0.003));
    }

    @Test
    void refitFollowsTheVertices() {
        TriangleMesh sphere = Shapes.sphere(10, 3);
        TriangleMesh away = Shapes.moved(sphere, 100, -20, 3);
        TriangleTree tree = new TriangleTree(sphere);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(1, 2, 3, hit);
        tree.refit(away.positions());
        TriangleTree fresh = new TriangleTree(away);
        TriangleTree.Hit expected = new TriangleTree.Hit();
        for (int i = 0; i < 50; i++) {
            tree.closest(3 * i, 2 * i, i, hit);
            fresh.closest(3 * i, 2 * i, i, expected);
            assertThat(hit.distanceSquared).isEqualTo(expected.distanceSquared);
            assertThat(hit.triangle).isEqualTo(expected.triangle);
        }
    }

    @Test
    void aRayThroughATorusMeetsItFourTimesAndFirstOnTheNearSide() {
        TriangleTree tree = new TriangleTree(Shapes.torus(10, 3, 48, 24));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        assertThat(tree.countAlongRay(-20, 0.01, 0.02, 1, 0, 0, hit)).isEqualTo(4);
        assertThat(tree.nearestAlongRay(-20, 0.01, 0.02, 2, 0, 0, hit)).isTrue();
        assertThat(hit.x).isCloseTo(-13, within(0.05));
        assertThat(hit.rayParameter).isCloseTo(3.5, within(0.05));
        assertThat(Math.sqrt(hit.distanceSquared)).isCloseTo(7, within(0.05));
        assertThat(tree.nearestAlongRay(-20, 0.01, 0.02, -1, 0, 0, hit)).isFalse();
        assertThat(tree.countAlongRay(0, 0, 50, 0, 0, -1, hit)).isZero();
    }

    @Test
    void insideATorusIsNearerItsCircleThanItsTubesRadius() {
        TriangleTree tree = new TriangleTree(Shapes.torus(10, 3, 96, 48));
        Random random = new Random(5);
        for (int i = 0; i < 500; i++) {
            double x = 28 * random.nextDouble() - 14;
            double y = 28 * random.nextDouble() - 14;
            double z = 8 * random.nextDouble() - 4;
            double tube = Math.hypot(Math.hypot(x, y) - 10, z);
            if (Math.abs(tube - 3) > 0.03) {
                assertThat(tree.isInside(x, y, z)).isEqualTo(tube < 3);
                assertThat(tree.windingNumber(x, y, z)).isCloseTo(tube < 3 ? 1 : 0, within(ROUNDING));
            }
        }
    }

    @Test
    void anEmptyMeshHasNoNearestPoint() {
        TriangleTree tree = new TriangleTree(new TriangleMesh(new double[0], new int[0]));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        assertThat(tree.closest(0, 0, 0, hit)).isFalse();
        assertThat(tree.nearestAlongRay(0, 0, 0, 1, 0, 0, hit)).isFalse();
        assertThat(tree.isInside(0, 0, 0)).isFalse();
    }

    /** Random triangles, some of them points, lines with corners in any order, or slivers. */
    static TriangleMesh soupWithDegenerates(Random random, int triangles) {
        double[] p = new double[9 * triangles];
        int[] t = new int[3 * triangles];
        for (int i = 0; i < triangles; i++) {
            for (int k = 0; k < 9; k++) {
                p[9 * i + k] = 10 * random.nextDouble();
            }
            int kind = random.nextInt(6);
            double s = 3 * random.nextDouble() - 1;
            for (int k = 0; k < 3; k++) {
                int a = 9 * i + k;
                if (kind == 0) {
                    p[a + 3] = p[a];
                    p[a + 6] = p[a];
                } else if (kind == 1) {
                    p[a + 6] = p[a] + s * (p[a + 3] - p[a]);
                } else if (kind == 2) {
                    p[a + 6] = p[a] + s * (p[a + 3] - p[a]) + 1e-7 * random.nextDouble();
                } else if (kind == 3) {
                    p[a + 6] = p[a];
                }
            }
            t[3 * i] = 3 * i;
            t[3 * i + 1] = 3 * i + 1;
            t[3 * i + 2] = 3 * i + 2;
        }
        return new TriangleMesh(p, t);
    }

    /**
     * An independent answer: the nearest of the three sides, and of the plane where its foot lies within, by the
     * normal.
     */
    static double distanceByRefinement(TriangleMesh mesh, int triangle, double[] q) {
        double[][] c = new double[3][3];
        for (int k = 0; k < 3; k++) {
            System.arraycopy(mesh.positions(), 3 * mesh.triangles()[3 * triangle + k], c[k], 0, 3);
        }
        double best = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double[] a = c[k];
            double[] e = minus(c[(k + 1) % 3], a);
            double length = dot(e, e);
            double s = length > 0 ? Math.max(0, Math.min(1, dot(minus(q, a), e) / length)) : 0;
            double[] r = {q[0] - a[0] - s * e[0], q[1] - a[1] - s * e[1], q[2] - a[2] - s * e[2]};
            best = Math.min(best, Math.sqrt(dot(r, r)));
        }
        double[] n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
        double length = Math.sqrt(dot(n, n));
        boolean within = length > 0;
        for (int k = 0; k < 3; k++) {
            within &= dot(cross(minus(c[(k + 1) % 3], c[k]), minus(q, c[k])), n) > 0;
        }
        return within ? Math.min(best, Math.abs(dot(minus(q, c[0]), n)) / length) : best;
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
}
