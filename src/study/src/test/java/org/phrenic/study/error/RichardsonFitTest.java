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
            assertThat(fit.scatter()).isLessThan(2e-4);
            assertThat(fit.change()).isCloseTo(-0.2 * Math.pow(EDGES[0], order), within(2e-3));
            assertThat(fit.hasOrder()).isTrue();
        }
    }

    @Test
    void valuesThatDoNotSettleOrMoreThanConvergeScatterHaveNoOrder() {
        RichardsonFit growing = RichardsonFit.of(EDGES, new double[] {15, 14.9, 14.7, 14.3});
        assertThat(growing.order()).isCloseTo(RichardsonFit.MIN_ORDER, within(1e-3));
        assertThat(growing.hasOrder()).isFalse();
        assertThat(RichardsonFit.of(EDGES, new double[] {15, 14, 15, 14.5}).hasOrder())
                .isFalse();
    }

    /** With deviations that are orthogonal to a straight line: they leave the fit of order 1 as it is. */
    private static double[] scattered(double[] edges, double size) {
        double[] deviations = {1, -2, 1, 0, -1, 2, -1};
        double[] values = new double[edges.length];
        Arrays.setAll(values, i -> 50 - 0.1 * edges[i] + size * deviations[i]);
        return values;
    }

    @Test
    void convergenceIsToldFromScatter() {
        double[] edges = {10, 9, 8, 7, 6, 5, 4};
        double[] much = scattered(edges, 0.3);
        RichardsonFit fit = RichardsonFit.of(edges, scattered(edges, 0.02));
        assertThat(fit.hasOrder()).isTrue();
        assertThat(fit.limit()).isCloseTo(50, within(0.2));
        // The root of the sum of squares 12 · 0.02² over 7 - 3 meshes.
        assertThat(fit.scatter()).isCloseTo(0.02 * Math.sqrt(3), within(0.005));
        assertThat(RichardsonFit.of(edges, much).hasOrder()).isFalse();
        RichardsonFit fourTimes = RichardsonFit.of(edges, scattered(edges, 0.15));
        assertThat(Math.abs(fourTimes.change()) / fourTimes.scatter()).isBetween(3.0, 4.0);
        assertThat(fourTimes.hasOrder()).isTrue();
        RichardsonFit twice = RichardsonFit.of(edges, scattered(edges, 0.22));
        assertThat(Math.abs(twice.change()) / twice.scatter()).isBetween(2.0, 3.0);
        assertThat(twice.order()).isBetween(0.5, 3.5);
        assertThat(twice.hasOrder()).isFalse();
    }

    @Test
    void twoMeshesUnequalCountsAndEdgesThatGrowAreRefused() {
        assertThatThrownBy(() -> RichardsonFit.of(new double[] {2, 1}, new double[] {2, 1}))
                .hasMessageContaining("at least three");
        assertThatThrownBy(() -> RichardsonFit.of(EDGES, new double[] {1, 2, 3}))
                .hasMessageContaining("found 4 edge lengths and 3 values, expected as many values as edge lengths");
        for (double[] edges : new double[][] {{1, 2, 3}, {3, 3, 1}, {2, 1, 0}, {Double.NaN, 2, 1}}) {
            assertThatThrownBy(() -> RichardsonFit.of(edges, new double[] {1, 2, 3}))
                    .hasMessageContaining("expected positive ones that decrease");
        }
    }
}
