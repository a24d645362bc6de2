package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class RichardsonFitTest {
    private static final double[] EDGES = {9, 6, 4, 8.0 / 3};

    private static double[] values(double limit, double slope, double order) {
        return Arrays.stream(EDGES).map(h -> limit + slope * Math.pow(h, order)).toArray();
    }

    @Test
    void limitAndOrderOfAPowerAreFound() {
        for (double order : new double[] {0.5, 1, 2, 3}) {
            RichardsonFit fit = RichardsonFit.of(EDGES, values(15, -0.2, order));
            assertThat(fit.order()).isCloseTo(order, within(1e-4));
            assertThat(fit.limit()).isCloseTo(15, within(1e-3));
            assertThat(fit.deviation()).isLessThan(1e-4);
            assertThat(fit.isMonotone()).isTrue();
        }
    }

    @Test
    void valuesThatDoNotSettleHaveNoOrderAndAreNotMonotone() {
        RichardsonFit growing = RichardsonFit.of(EDGES, new double[] {15, 14.9, 14.7, 14.3});
        assertThat(growing.order()).isCloseTo(RichardsonFit.MIN_ORDER, within(1e-3));
        assertThat(growing.isMonotone()).isFalse();
        assertThat(RichardsonFit.of(EDGES, new double[] {15, 14, 15, 14.5}).isMonotone())
                .isFalse();
    }

    @Test
    void twoMeshesAreTooFew() {
        assertThatThrownBy(() -> RichardsonFit.of(new double[] {2, 1}, new double[] {2, 1}))
                .hasMessageContaining("at least three");
    }
}
