package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.access.imaging.CArm;
import org.phrenic.access.plan.Aids;
import org.phrenic.ui.access.FluoroscopyShot;
import org.phrenic.ui.access.IdleRehearsal;
import org.phrenic.ui.widget.Theme;

/** What is written into the X-ray picture. */
class FluoroscopyDockTest {
    private static final int SIDE = 200;
    private static final int BONE = 0xb0b0b0;
    /** Of the brightest and the darkest place about a letter: that of text that can be read. */
    private static final double CONTRAST = 4.5;

    private static final double FLARE = 0.05;

    /** The letters alone tell the patient's sides apart, and the pictures are the same in both themes. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theSidesOfThePatientCanBeReadOnBoneInEachTheme(boolean dark) {
        CArm arm = new CArm(
                new double[3],
                0,
                0,
                CArm.SOURCE_DETECTOR_MM,
                CArm.SOURCE_ISOCENTRE_MM,
                new CArm.Detector(300, SIDE, SIDE));
        BufferedImage bone = filled(BONE);
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            Theme.install(dark);
            rehearsal.setAids(Aids.PICTURES);
            FluoroscopyDock dock = new FluoroscopyDock(session, rehearsal);
            dock.onState();
            dock.onFluoroscopy(new FluoroscopyShot(arm, bone, null));
            Component picture = Stream.of(dock.getComponents())
                    .filter(part -> "X-ray picture".equals(part.getName()))
                    .findFirst()
                    .orElseThrow();
            picture.setSize(SIDE, SIDE);
            BufferedImage painted = filled(0);
            Graphics2D g = painted.createGraphics();
            picture.paint(g);
            g.dispose();
            assertThat(contrast(painted, 0)).as("R").isGreaterThan(CONTRAST);
            assertThat(contrast(painted, SIDE / 2)).as("L").isGreaterThan(CONTRAST);
            assertThat(brighterThanBone(painted, 0))
                    .as("an R has more strokes than an L")
                    .isGreaterThan(brighterThanBone(painted, SIDE / 2));
        });
        Theme.install(false);
    }

    private static BufferedImage filled(int rgb) {
        BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        image.setRGB(
                0,
                0,
                SIDE,
                SIDE,
                IntStream.generate(() -> rgb).limit(SIDE * SIDE).toArray(),
                0,
                SIDE);
        return image;
    }

    /** Contrast of the brightest to the darkest pixel halfway up in a half of a picture. */
    private static double contrast(BufferedImage image, int fromColumn) {
        double[] shades = IntStream.of(image.getRGB(fromColumn, SIDE / 3, SIDE / 2, SIDE / 3, null, 0, SIDE / 2))
                .mapToDouble(FluoroscopyDockTest::luminance)
                .sorted()
                .toArray();
        return (shades[shades.length - 1] + FLARE) / (shades[0] + FLARE);
    }

    /** Pixels of text halfway up in a half of a picture. */
    private static long brighterThanBone(BufferedImage image, int fromColumn) {
        return IntStream.of(image.getRGB(fromColumn, SIDE / 3, SIDE / 2, SIDE / 3, null, 0, SIDE / 2))
                .filter(rgb -> luminance(rgb) > luminance(BONE))
                .count();
    }

    private static double luminance(int rgb) {
        return 0.2126 * linear(rgb >> 16) + 0.7152 * linear(rgb >> 8) + 0.0722 * linear(rgb);
    }

    private static double linear(int channel) {
        return StrictMath.pow((channel & 0xff) / 255.0, 2.2);
    }
}
