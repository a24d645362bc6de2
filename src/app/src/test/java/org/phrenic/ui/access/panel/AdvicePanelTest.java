package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** Colours of the advice over the breath beside that at present. */
class AdvicePanelTest {
    private static final int SIDE = 60;

    private final AdvicePanel breath = new AdvicePanel("Path over the breath");
    private final AdvicePanel present = new AdvicePanel("Path at present");

    /** Number of pixels in the colour that marks a level. */
    private static long marked(AdvicePanel panel, PathAdvice.Level level) {
        BufferedImage picture = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        panel.setSize(SIDE, SIDE);
        panel.paint(picture.createGraphics());
        int sought = new Color(NeedleMarkers.rgb(level)).getRGB();
        return IntStream.range(0, SIDE * SIDE)
                .filter(i -> picture.getRGB(i % SIDE, i / SIDE) == sought)
                .count();
    }

    @Test
    void aFreeBreathIsNotGreenWhileThePresentIsWorse() {
        EventThread.run(() -> {
            Theme.install(false);
            breath.setAdvice(PathAdvice.Level.FREE, "Free over the whole breath", "Margin 6.0 mm from right lung");
            for (PathAdvice.Level worse : new PathAdvice.Level[] {PathAdvice.Level.CAREFUL, PathAdvice.Level.BARRED}) {
                present.setAdvice(worse, "Now: runs close below rib 9", "");
                breath.giveWayTo(present);
                assertThat(marked(breath, PathAdvice.Level.FREE)).isZero();
                assertThat(breath.isOpaque()).isFalse();
                assertThat(marked(present, worse)).isPositive();
            }
        });
    }

    @Test
    void adviceHasItsColourBesideOneThatIsNoWorseOrNotShown() {
        EventThread.run(() -> {
            Theme.install(false);
            breath.setAdvice(PathAdvice.Level.CAREFUL, "Free in 60 % of the breath", "");
            present.setAdvice(PathAdvice.Level.FREE, "Now free: 6.0 mm from right lung", "");
            breath.giveWayTo(present);
            assertThat(marked(breath, PathAdvice.Level.CAREFUL)).isPositive();
            present.setAdvice(PathAdvice.Level.BARRED, "Now barred", "");
            present.setVisible(false);
            breath.giveWayTo(present);
            assertThat(marked(breath, PathAdvice.Level.CAREFUL)).isPositive();
        });
    }

    @Test
    void whatIsNotComputedYetHasNoColourOfAnEarlierVerdict() {
        EventThread.run(() -> {
            Theme.install(false);
            breath.setAdvice(PathAdvice.Level.FREE, "Free over the whole breath", "Margin 6.0 mm from right lung");
            breath.setUnknown("Computing the path over the breath");
            assertThat(marked(breath, PathAdvice.Level.FREE)).isZero();
            assertThat(breath.text()).doesNotContain("Free", "Margin");
            breath.setAdvice(PathAdvice.Level.FREE, "Free over the whole breath", "");
            assertThat(marked(breath, PathAdvice.Level.FREE)).isPositive();
        });
    }
}
