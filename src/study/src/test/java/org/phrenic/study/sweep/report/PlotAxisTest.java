package org.phrenic.study.sweep.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlotAxisTest {
    private static List<String> texts(double... values) {
        PlotAxis axis = PlotAxis.around(0, 100, values);
        return axis.ticks().stream().map(axis::text).toList();
    }

    @Test
    void aTickIsWrittenAsAReaderWritesIt() {
        assertThat(texts(0, 20000)).containsExactly("0", "5000", "10000", "15000", "20000");
        assertThat(texts(0, 0.5)).containsExactly("0", "0.2", "0.4");
    }

    /** A response that a factor hardly moves: rounded ticks would be read as other values, or twice. */
    @Test
    void ticksOfASmallRangeOfLargeNumbersHaveTheDigitsOfTheirStep() {
        assertThat(texts(131.2, 131.4)).containsExactly("131.2", "131.25", "131.3", "131.35", "131.4");
        assertThat(texts(2501.2, 2503.1)).containsExactly("2501.5", "2502", "2502.5", "2503");
        assertThat(texts(12341, 12359)).containsExactly("12345", "12350", "12355");
        assertThat(texts(-131.4, -131.2)).contains("-131.25");
    }

    /** Means of equal values differ in their last bits. */
    @ParameterizedTest
    @ValueSource(doubles = {131.2, -131.2, 1, 9.99, 0.02})
    void ticksOfValuesThatDifferByRoundingAreShort(double value) {
        assertThat(texts(value, Math.nextUp(value)))
                .hasSizeGreaterThan(1)
                .doesNotHaveDuplicates()
                .allMatch(text ->
                        text.replaceFirst("^-?0*\\.?0*", "").replace(".", "").length() <= 8);
    }

    @Test
    void ticksOfAConstantSeriesOfZerosAreShort() {
        assertThat(texts(0, 0)).contains("-5e-10", "0", "5e-10");
    }
}
