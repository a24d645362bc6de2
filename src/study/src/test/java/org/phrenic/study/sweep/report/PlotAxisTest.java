package org.phrenic.study.sweep.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class PlotAxisTest {
    private static List<String> texts(double... values) {
        return PlotAxis.around(0, 100, values).ticks().stream()
                .map(PlotAxis::text)
                .toList();
    }

    @Test
    void aTickIsWrittenAsAReaderWritesIt() {
        assertThat(texts(0, 20000)).containsExactly("0", "5000", "10000", "15000", "20000");
        assertThat(texts(0, 0.5)).containsExactly("0", "0.2", "0.4");
    }

    @Test
    void ticksOfAConstantSeriesOfZerosAreShort() {
        assertThat(texts(0, 0)).contains("-5e-10", "0", "5e-10");
    }
}
