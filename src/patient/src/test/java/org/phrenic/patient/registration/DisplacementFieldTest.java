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
