package org.phrenic.fit.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Scenario;

class SearchSpaceTest {
    private static final List<FitParameter> PARAMETERS = FitParameter.defaults(Scenario.defaults());
    private static final SearchSpace SPACE = new SearchSpace(PARAMETERS);

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
