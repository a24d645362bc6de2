package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Shares by which edges of muscle shorten, and stiffness of edges across the tendon's border. */
class FibreLawTest {

    /**
     * A strain E changes the length of an edge with unit direction n by n·E n. With fibres along x, the edges of a
     * triangle of any shape and orientation ask for E = -diag(7/8, -1/8): the three shares fit one tensor.
     */
    @Test
    void theEdgesOfEveryTriangleAskForOneStrain() {
        Random random = new Random(7);
        double[] fibre = {1, 0, 0};
        for (int k = 0; k < 20; k++) {
            double[] p = new double[9];
            for (int i = 0; i < 3; i++) {
                p[3 * i] = random.nextGaussian();
                p[3 * i + 1] = random.nextGaussian();
            }
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                double dx = p[3 * j] - p[3 * i];
                double dy = p[3 * j + 1] - p[3 * i + 1];
                double shortened = (7 * dx * dx - dy * dy) / 8 / (dx * dx + dy * dy);
                assertThat(DiaphragmPart.alongFibre(p, i, j, fibre, 0)).isCloseTo(shortened, within(1e-12));
            }
        }
    }

    @Test
    void edgesWithoutFibresDoNotShorten() {
        assertThat(DiaphragmPart.alongFibre(new double[] {0, 0, 0, 1, 0, 0}, 0, 1, new double[3], 0))
                .isZero();
    }

    /** Half of an edge in tissue ten times as stiff: compliances 1/20 and 1/2 add. */
    @Test
    void anEdgeAcrossTheBorderIsTendonAndMuscleInSeries() {
        assertThat(DiaphragmPart.inSeries(0, 10)).isEqualTo(1);
        assertThat(DiaphragmPart.inSeries(0.5, 10)).isCloseTo(1 / 0.55, within(1e-12));
        assertThat(DiaphragmPart.inSeries(1, 10)).isEqualTo(10);
    }
}
