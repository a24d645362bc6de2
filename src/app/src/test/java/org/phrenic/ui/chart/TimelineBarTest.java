package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.ui.session.EventThread;

class TimelineBarTest {
    private static final double END_S = 10;

    /** Arrow keys move the cursor, which only the picture shows otherwise. */
    @Test
    void aScreenReaderIsToldTheTimeOfTheCursor() {
        EventThread.run(() -> {
            TimelineBar bar = new TimelineBar(time -> {}, frames -> {});
            bar.setTimeline(0, END_S, 3.25, List.of());
            assertThat(bar.getAccessibleContext().getAccessibleDescription()).isEqualTo("3.25 s");
            bar.setTimeline(0, END_S, Double.NaN, List.of());
            assertThat(bar.getAccessibleContext().getAccessibleDescription()).isEqualTo(bar.getToolTipText());
        });
    }
}
