package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EventThread;

/** The names on the bands of a quiet breath. */
class PhaseBarTest {
    private static final int HEIGHT = 30;
    private static final Font LETTERS = new Font(Font.DIALOG, Font.PLAIN, 13);

    private static int wordWidth() {
        return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)
                .createGraphics()
                .getFontMetrics(LETTERS)
                .stringWidth("Pause");
    }

    /** Colours of the inner part of the pause's band, from left to right, in a bar whose pause is so wide. */
    private static int[] pause(double widthOfPause) {
        double share = Scenario.defaults().breathing().parameters().pauseFraction();
        int width = (int) Math.ceil(widthOfPause / share);
        BufferedImage picture = new BufferedImage(width, HEIGHT, BufferedImage.TYPE_INT_RGB);
        EventThread.run(() -> {
            PhaseBar bar = new PhaseBar();
            bar.setFont(LETTERS);
            bar.setSize(width, HEIGHT);
            bar.setPattern(Scenario.defaults());
            Graphics2D g = picture.createGraphics();
            bar.paint(g);
            g.dispose();
        });
        int from = (int) Math.ceil((1 - share) * width) + 1;
        // The middle of the height, without the round corners.
        return IntStream.range(from, width - 1)
                .flatMap(x -> IntStream.range(HEIGHT / 3, 2 * HEIGHT / 3).map(y -> picture.getRGB(x, y)))
                .toArray();
    }

    private static long kindsOfColour(double widthOfPause) {
        return Arrays.stream(pause(widthOfPause)).distinct().count();
    }

    @Test
    void aPauseALittleTooNarrowForItsNameHasItInSmallerLetters() {
        assertThat(kindsOfColour(wordWidth() + 20))
                .as("colours, letters with room")
                .isGreaterThan(1);
        assertThat(kindsOfColour(wordWidth() + 4))
                .as("colours, letters with little room")
                .isGreaterThan(1);
    }

    @Test
    void aPauseOfHalfTheWidthOfItsNameHasNone() {
        assertThat(kindsOfColour(0.5 * wordWidth()))
                .as("colours of the band alone")
                .isEqualTo(1);
    }
}
