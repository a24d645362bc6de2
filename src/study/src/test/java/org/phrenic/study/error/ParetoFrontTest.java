package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ParetoFrontTest {
    @Test
    void whatIsBothDearerAndWorseIsNotOnTheFront() {
        double[] cost = {4, 1, 2, 3, 5};
        double[] error = {0.1, 8, 4, 6, 0.1};
        // 3 costs more than 2 and errs more; 5 costs more than 4 for the same error.
        assertThat(ParetoFront.of(cost, error)).containsExactly(true, true, true, false, false);
    }

    @Test
    void whatIsNoNumberIsNeverOnTheFront() {
        assertThat(ParetoFront.of(new double[] {1, 2, Double.NaN}, new double[] {Double.NaN, 3, 1}))
                .containsExactly(false, true, false);
    }
}
