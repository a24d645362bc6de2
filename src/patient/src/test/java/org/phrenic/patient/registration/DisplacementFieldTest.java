package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.concurrent.ForkJoinPool;
import org.junit.jupiter.api.Test;

/** The smooth displacement that carries a template to a scan. */
class DisplacementFieldTest {
    private static final double[] BOUNDS = {0, 0, 0, 100, 100, 100};
    private static final double RADIUS_MM = 30;

    /** A lattice through the box. */
    private static double[] points(int along) {
        double[] p = new double[3 * along * along * along];
        for (int i = 0; i < p.length / 3; i++) {
            p[3 * i] = 100.0 * (i % along) / (along - 1);
            p[3 * i + 1] = 100.0 * (i / along % along) / (along - 1);
            p[3 * i + 2] = 100.0 * (i / along / along) / (along - 1);
        }
        return p;
    }

    private static double[] shifted(double[] points) {
        double[] p = points.clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] += 5;
            p[i + 2] -= 3;
        }
        return p;
    }

    @Test
    void whereAllPointsGoTheSameWaySpaceGoesIt() {
        double[] from = points(9);
        double[] p = {50, 50, 50};
        new DisplacementField(from, shifted(from), RADIUS_MM, BOUNDS).apply(p);
        // What draws to nothing, 0.3 of a point, is a hundredth of the weight here.
        assertThat(p[0]).isCloseTo(55, within(0.2));
        assertThat(p[1]).isCloseTo(50, within(1e-9));
        assertThat(p[2]).isCloseTo(47, within(0.2));
    }

    /** A displacement that is linear in each coordinate. */
    private static double linear(double[] p, int i, int axis) {
        return new double[] {
                    0.02 * p[i] - 0.05 * p[i + 1] + 3,
                    0.04 * p[i + 1] + 0.01 * p[i + 2],
                    0.03 * p[i] - 0.06 * p[i + 2] - 2
                }
                [axis];
    }

    /**
     * Points 10 mm apart, as the nodes of the field are, and around it: each node has 1, 6, 12, 8, 6, 24, 24 and 12 of
     * them at squares of 0 to 6 and 8 steps, with a weight of 2103/81 in all. Displacements about it cancel but for its
     * own, and between nodes the field is linear.
     */
    @Test
    void aLinearDisplacementIsCarriedButForWhatDrawsToNothing() {
        double[] from = new double[3 * 17 * 15 * 13];
        for (int i = 0; i < from.length / 3; i++) {
            from[3 * i] = 10 * (i % 17) - 30;
            from[3 * i + 1] = 10 * (i / 17 % 15) - 30;
            from[3 * i + 2] = 10 * (i / 17 / 15) - 30;
        }
        double[] to = from.clone();
        for (int i = 0; i < from.length; i++) {
            to[i] += linear(from, i - i % 3, i % 3);
        }
        double[] p = {13, 27, 41, 88, 6, 59, 4, 71, 15};
        double[] expected = p.clone();
        double weight = 2103 / 81.0;
        for (int i = 0; i < p.length; i++) {
            expected[i] += linear(p, i - i % 3, i % 3) * weight / (weight + 0.3);
        }
        new DisplacementField(from, to, RADIUS_MM, new double[] {0, 0, 0, 100, 80, 60}).apply(p);
        assertThat(p).containsExactly(expected, within(1e-9));
    }

    @Test
    void whereNoPointIsNearNothingMoves() {
        double[] p = {60, 70, 80, 4, 0, 0};
        new DisplacementField(new double[3], new double[] {5, 5, 5}, RADIUS_MM, BOUNDS).apply(p);
        assertThat(p).startsWith(60, 70, 80);
        assertThat(p[3]).isGreaterThan(6);
    }

    @Test
    void isTheSameOnAnyNumberOfThreads() throws Exception {
        double[] from = points(9);
        double[] to = shifted(points(9));
        for (int i = 0; i < to.length; i++) {
            to[i] += Math.cos(i);
        }
        double[] many = points(4);
        new DisplacementField(from, to, RADIUS_MM, BOUNDS).apply(many);
        double[] one = points(4);
        ForkJoinPool alone = new ForkJoinPool(1);
        try {
            alone.submit(() -> new DisplacementField(from, to, RADIUS_MM, BOUNDS).apply(one))
                    .get();
        } finally {
            alone.shutdown();
        }
        assertThat(many).isEqualTo(one);
    }
}
