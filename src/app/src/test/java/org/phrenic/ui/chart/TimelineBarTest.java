package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Font;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.breathing.RespiratoryPhase;
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

    /** Of a time without samples nothing is known; a pause is what a body does. */
    @Test
    void aTimeOfWhichNothingIsKnownHasTheColourOfNoPhase() {
        EventThread.run(() -> {
            TimelineBar bar = new TimelineBar(time -> {}, frames -> {});
            bar.setFont(new Font(Font.DIALOG, Font.PLAIN, 12));
            bar.setSize(400, bar.getPreferredSize().height);
            bar.setTimeline(
                    0, END_S, Double.NaN, List.of(new PhaseBands.Band(END_S / 2, END_S, RespiratoryPhase.PAUSE, 0)));
            BufferedImage picture = new BufferedImage(bar.getWidth(), bar.getHeight(), BufferedImage.TYPE_INT_RGB);
            bar.paint(picture.getGraphics());
            int known = picture.getRGB(bar.getWidth() - 20, 5);
            assertThat(known).isEqualTo(PhaseColours.of(RespiratoryPhase.PAUSE).getRGB());
            for (RespiratoryPhase phase : RespiratoryPhase.values()) {
                assertThat(picture.getRGB(20, 5))
                        .isNotEqualTo(PhaseColours.of(phase).getRGB());
            }
        });
    }
}
