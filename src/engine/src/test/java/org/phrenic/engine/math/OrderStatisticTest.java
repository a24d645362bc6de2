package org.phrenic.engine.math;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class OrderStatisticTest {
    @Test
    void theMedianIsTheMiddleOrTheMeanOfTheMiddleTwo() {
        assertThat(OrderStatistic.median(new double[] {9, 1, 4})).isEqualTo(4);
        assertThat(OrderStatistic.median(new double[] {9, 1, 4, 2})).isEqualTo(3);
        assertThat(OrderStatistic.median(new double[0])).isNaN();
    }

    @Test
    void anOrderStatisticIsOneOfTheValuesWhateverTheirOrder() {
        double[] values =
                IntStream.rangeClosed(0, 100).mapToDouble(i -> 100 - i).toArray();
        assertThat(OrderStatistic.atShare(values, 0.95)).isEqualTo(95);
        assertThat(OrderStatistic.atShare(values, 0)).isZero();
        assertThat(OrderStatistic.atShare(values, 1)).isEqualTo(100);
        assertThat(values[0]).as("the values stay as they are").isEqualTo(100);
        assertThat(OrderStatistic.atShare(new double[0], 0.95)).isZero();
    }
}
