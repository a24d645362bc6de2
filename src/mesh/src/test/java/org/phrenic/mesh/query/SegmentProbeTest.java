package org.phrenic.mesh.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

/** Piercing and distance of a straight segment, against closed forms and against every triangle without a tree. */
class SegmentProbeTest {
    private static final double EXACT = 1e-12;
    private static final double TOLERANCE_MM = 1e-9;

    private final SegmentProbe probe = new SegmentProbe();

    @Test
    void aBoxIsEnteredAndLeftAtItsFaces() {
        TriangleTree box = new TriangleTree(Shapes.box(10, 20, 30));
        probe.set(-5, 7, 11, 45, 7, 11);
        assertThat(probe.intersect(box)).isEqualTo(2);
        assertThat(probe.depth(0)).isCloseTo(5, within(EXACT));
        assertThat(probe.facing(0)).isEqualTo(1);
        assertThat(probe.depth(1)).isCloseTo(15, within(EXACT));
        assertThat(probe.facing(1)).isEqualTo(-1);
        probe.set(45, 7, 11, -5, 7, 11);
        assertThat(probe.intersect(box)).isEqualTo(2);
        assertThat(probe.depth(0)).isCloseTo(35, within(EXACT));
        assertThat(probe.facing(0)).isEqualTo(1);
    }

    @Test
    void aSegmentThatEndsWithinHasNotLeft() {
        TriangleTree box = new TriangleTree(Shapes.box(10, 20, 30));
        probe.set(-5, 7, 11, 2, 7, 11);
        assertThat(probe.intersect(box)).isEqualTo(1);
        probe.set(-5, 7, 11, -1, 7, 11);
        assertThat(probe.intersect(box)).isZero();
    }

    @Test
    void throughCornersAndEdgesASegmentPassesOnce() {
        TriangleMesh ball = Shapes.sphere(10, 2);
        TriangleTree tree = new TriangleTree(ball);
        int[] t = ball.triangles();
        for (int k = 0; k < t.length; k++) {
            int a = t[k];
            int b = t[k - k % 3 + (k + 1) % 3];
            // Through a corner, and through the middle of an edge, from outside to the centre and out beyond it.
            through(tree, ball.x(a), ball.y(a), ball.z(a));
            through(tree, 0.5 * (ball.x(a) + ball.x(b)), 0.5 * (ball.y(a) + ball.y(b)), 0.5 * (ball.z(a) + ball.z(b)));
        }
    }

    private void through(TriangleTree ball, double x, double y, double z) {
        probe.set(3 * x, 3 * y, 3 * z, 0, 0, 0);
        assertThat(probe.intersect(ball)).isEqualTo(1);
        assertThat(probe.facing(0)).isEqualTo(1);
        probe.set(3 * x, 3 * y, 3 * z, -3 * x, -3 * y, -3 * z);
        assertThat(probe.intersect(ball)).isEqualTo(2);
        assertThat(probe.facing(1)).isEqualTo(-1);
    }

    @Test
    void alongAnEdgeOrInAFaceEntriesAndExitsComeInPairs() {
        TriangleTree box = new TriangleTree(Shapes.box(10, 10, 10));
        double[][] grazing = {
            {-5, 0, 0, 15, 0, 0},
            {-5, 10, 10, 15, 10, 10},
            {-5, 3, 0, 15, 3, 0},
            {-5, -5, 0, 15, 15, 0},
            {-5, 0, -5, 15, 0, 15},
        };
        for (double[] s : grazing) {
            probe.set(s[0], s[1], s[2], s[3], s[4], s[5]);
            int count = probe.intersect(box);
            assertThat(count).isIn(0, 2);
            if (count == 2) {
                assertThat(probe.facing(0) + probe.facing(1)).isZero();
            }
        }
    }

    @Test
    void everyTriangleWithoutATreeSaysTheSame() {
        TriangleMesh torus = Shapes.torus(20, 6, 40, 20);
        TriangleTree tree = new TriangleTree(torus);
        SegmentProbe one = new SegmentProbe();
        SplittableRandom random = new SplittableRandom(1);
        int pierced = 0;
        for (int i = 0; i < 400; i++) {
            double[] s = random.doubles(6, -30, 30).toArray();
            probe.set(s[0], s[1], s[2], s[3], s[4], s[5]);
            one.set(s[0], s[1], s[2], s[3], s[4], s[5]);
            int all = 0;
            double least = Double.POSITIVE_INFINITY;
            for (int t = 0; t < torus.triangleCount(); t++) {
                TriangleTree single = new TriangleTree(triangle(torus, t));
                all += one.intersect(single);
                least = Math.min(least, one.distance(single, 1000));
            }
            assertThat(probe.intersect(tree)).isEqualTo(all);
            assertThat(probe.distance(tree, 1000)).isEqualTo(least);
            assertThat(least == 0).isEqualTo(all > 0);
            pierced += all > 0 ? 1 : 0;
        }
        assertThat(pierced).isBetween(40, 360);
    }

    private static TriangleMesh triangle(TriangleMesh mesh, int t) {
        double[] p = new double[9];
        for (int k = 0; k < 3; k++) {
            System.arraycopy(mesh.positions(), 3 * mesh.triangles()[3 * t + k], p, 3 * k, 3);
        }
        return new TriangleMesh(p, new int[] {0, 1, 2});
    }

    @Test
    void theDistanceToABoxIsKnownInClosedForm() {
        TriangleTree box = new TriangleTree(Shapes.box(10, 10, 10));
        // Past a face, past an edge that it runs along, and short of a face.
        probe.set(-20, 5, 13, 20, 5, 13);
        assertThat(probe.distance(box, 100)).isCloseTo(3, within(TOLERANCE_MM));
        probe.set(13, -20, 14, 13, 20, 14);
        assertThat(probe.distance(box, 100)).isCloseTo(5, within(TOLERANCE_MM));
        assertThat(probe.nearestDepth()).isBetween(20.0, 30.0);
        probe.set(5, 5, 40, 5, 5, 12);
        assertThat(probe.distance(box, 100)).isCloseTo(2, within(TOLERANCE_MM));
        assertThat(probe.nearestDepth()).isCloseTo(28, within(TOLERANCE_MM));
        assertThat(probe.distance(box, 1)).isEqualTo(1);
        assertThat(probe.nearestDepth()).isNaN();
    }

    /** Seen along the edge (10, y, 10) the segment lies on x + z = 25, which is nearest to it at (12.5, 12.5). */
    @Test
    void aSegmentAskewPassesAnEdgeAtItsMiddle() {
        TriangleTree box = new TriangleTree(Shapes.box(10, 10, 10));
        probe.set(5, -3, 20, 20, 13, 5);
        assertThat(probe.distance(box, 100)).isCloseTo(2.5 * Math.sqrt(2), within(TOLERANCE_MM));
        assertThat(probe.nearestDepth()).isCloseTo(probe.length() / 2, within(TOLERANCE_MM));
    }

    /** The line would pass the corner (10, 10, 10) at a distance of the square root of 8. */
    @Test
    void aSegmentThatEndsShortOfACornerIsNearestWithItsEnd() {
        TriangleTree box = new TriangleTree(Shapes.box(10, 10, 10));
        probe.set(30, 12, 12, 20, 12, 12);
        assertThat(probe.distance(box, 100)).isCloseTo(Math.sqrt(108), within(TOLERANCE_MM));
        assertThat(probe.nearestDepth()).isCloseTo(10, within(TOLERANCE_MM));
    }

    @Test
    void noPointOfASegmentIsNearerThanItsDistance() {
        TriangleTree box = new TriangleTree(Shapes.box(10, 10, 10));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 100; i++) {
            double[] s = random.doubles(6, -15, 25).toArray();
            probe.set(s[0], s[1], s[2], s[3], s[4], s[5]);
            double distance = probe.distance(box, 100);
            double nearest = Double.POSITIVE_INFINITY;
            int parts = 500;
            for (int k = 0; k <= parts; k++) {
                double u = (double) k / parts;
                box.closest(s[0] + u * (s[3] - s[0]), s[1] + u * (s[4] - s[1]), s[2] + u * (s[5] - s[2]), hit);
                nearest = Math.min(nearest, Math.sqrt(hit.distanceSquared));
            }
            assertThat(nearest).isBetween(distance - TOLERANCE_MM, distance + probe.length() / parts);
            double at = probe.nearestDepth() / probe.length();
            box.closest(s[0] + at * (s[3] - s[0]), s[1] + at * (s[4] - s[1]), s[2] + at * (s[5] - s[2]), hit);
            if (distance > 0) {
                assertThat(Math.sqrt(hit.distanceSquared)).isCloseTo(distance, within(TOLERANCE_MM));
            }
        }
    }
}
