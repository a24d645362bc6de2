package org.phrenic.fit.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Scenario;

class SearchSpaceTest {
    private static final List<FitParameter> PARAMETERS = FitParameter.defaults(Scenario.defaults());
    private static final SearchSpace SPACE = new SearchSpace(PARAMETERS);

    /** Without a ratio the drive itself is at its bound; with one, its stronger side is above it. */
    @Test
    void aDriveIsAtItsLowerBoundWhereTheMeanOfItsSidesIs() {
        for (double share : new double[] {0.4, 0.6}) {
            double[] point = new double[PARAMETERS.size()];
            Arrays.fill(point, share);
            int drive = index("muscle_activation");
            point[drive] = 0;
            double[] values = SPACE.values(point);
            assertThat(values[drive]).isGreaterThan(PARAMETERS.get(drive).minimum());
            for (int i = 0; i < values.length; i++) {
                assertThat(SPACE.isAtBound(values, i))
                        .describedAs(PARAMETERS.get(i).parameter().key())
                        .isEqualTo(i == drive);
            }
        }
    }

    @Test
    void aValueAtEitherEndIsAtItsBound() {
        double[] point = new double[PARAMETERS.size()];
        Arrays.fill(point, 0.5);
        point[index("bucket_handle")] = 0;
        point[index("rib_rotation")] = 1;
        double[] values = SPACE.values(point);
        assertThat(SPACE.isAtBound(values, index("bucket_handle"))).isTrue();
        assertThat(SPACE.isAtBound(values, index("rib_rotation"))).isTrue();
        assertThat(SPACE.isAtBound(values, index("muscle_activation"))).isFalse();
    }

    /** Of sides in the ratio 1.44 the stronger one has 1.2 times their geometric mean. */
    @Test
    void theCoordinateOfADriveIsTheGeometricMeanOfItsSides() {
        int drive = index("muscle_activation");
        int ratio = index("left_over_right");
        int along = index("front_over_back");
        for (double q : new double[] {1.44, 1 / 1.44}) {
            double[] point = new double[PARAMETERS.size()];
            Arrays.fill(point, 0.3);
            point[ratio] = PARAMETERS.get(ratio).toUnit(q);
            point[along] = PARAMETERS.get(along).toUnit(1);
            double[] values = SPACE.values(point);
            assertThat(values[ratio]).isCloseTo(q, within(1e-12));
            assertThat(values[drive]).isCloseTo(1.2 * PARAMETERS.get(drive).fromUnit(0.3), within(1e-9));
        }
    }

    private static int index(String key) {
        return IntStream.range(0, PARAMETERS.size())
                .filter(i -> PARAMETERS.get(i).parameter().key().equals(key))
                .findFirst()
                .orElseThrow();
    }

    /** Ratios on either side of 1, where no drive is at its bound. */
    @Test
    void oneValueMovesAlone() {
        for (double share : new double[] {0.4, 0.6}) {
            double[] centre = new double[PARAMETERS.size()];
            Arrays.fill(centre, share);
            double[] values = SPACE.values(centre);
            for (int i = 0; i < values.length; i++) {
                FitParameter p = PARAMETERS.get(i);
                double[] expected = values.clone();
                expected[i] = p.fromUnit(p.toUnit(values[i]) + 0.05);
                double[] point = centre.clone();
                double[] way = SPACE.wayOf(values, i, expected[i]);
                for (int k = 0; k < point.length; k++) {
                    point[k] += way[k];
                }
                assertThat(SPACE.values(point))
                        .describedAs(p.parameter().key())
                        .containsExactly(expected, within(1e-12));
            }
        }
    }
}
