package org.phrenic.scene.annotate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.mesh.Vectors;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourMap;
import org.phrenic.scene.style.ColourScale;

/** What is written over a picture: right, readable and within it. */
class AnnotationsTest {
    private static final double[] BODY = {-180, -120, 900, 190, 110, 1450};
    private static final int LIGHT = 0xf2f4f6;
    private static final int DARK = 0x15181c;

    private static BufferedImage blank(int width, int height, int background) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        g.setColor(new Color(background));
        g.fillRect(0, 0, width, height);
        g.dispose();
        return picture;
    }

    /** A light picture from the front with letters, the figure and, of a parallel camera, the ruler. */
    private static BufferedImage plain(int width, int height, Camera camera) {
        BufferedImage picture = blank(width, height, LIGHT);
        Graphics2D g = picture.createGraphics();
        new Annotations(true, "", "", "", Optional.empty(), "").drawStatic(g, camera, width, height, 1);
        g.dispose();
        return picture;
    }

    private static boolean isInk(BufferedImage picture, int x, int y) {
        return (picture.getRGB(x, y) & 0xff) < 0x80;
    }

    /** Pixels of ink in a square. */
    private static long ink(BufferedImage picture, int centreX, int centreY, int half) {
        return IntStream.range(centreY - half, centreY + half)
                .mapToLong(y -> IntStream.range(centreX - half, centreX + half)
                        .filter(x -> isInk(picture, x, y))
                        .count())
                .sum();
    }

    private static BufferedImage annotated(int width, int height, boolean light, Camera camera) {
        BufferedImage picture = blank(width, height, light ? LIGHT : DARK);
        new Annotations(
                        light,
                        "",
                        "",
                        "Displacement of the diaphragm",
                        Optional.of(ColourScale.sequential(20, "mm")),
                        "")
                .withTitle("Quiet breath, virtual adult male with a name that is long")
                .withTimestamp("1.25 s, breath 1 at 31 %")
                .draw(picture, camera);
        return picture;
    }

    private static int marked(BufferedImage picture, int x0, int y0, int x1, int y1, int background) {
        int count = 0;
        for (int y = y0; y < y1; y++) {
            for (int x = x0; x < x1; x++) {
                if ((picture.getRGB(x, y) & 0xffffff) != background) {
                    count++;
                }
            }
        }
        return count;
    }

    /** The darkest ink stays off the border; only rims may touch it. */
    @ParameterizedTest
    @CsvSource({"320,240", "240,320", "800,800", "1280,300", "8192,128", "2000,1500"})
    void nothingIsCutOff(int width, int height) {
        for (AnatomicalView view : AnatomicalView.values()) {
            for (boolean light : new boolean[] {true, false}) {
                Camera camera = Camera.of(view, BODY, (double) width / height).withProjection(true);
                BufferedImage p = annotated(width, height, light, camera);
                int background = light ? LIGHT : DARK;
                int border = marked(p, 0, 0, width, 1, background)
                        + marked(p, 0, height - 1, width, height, background)
                        + marked(p, 0, 0, 1, height, background)
                        + marked(p, width - 1, 0, width, height, background);
                assertThat(border).as("%s %d x %d", view, width, height).isZero();
                assertThat(marked(p, 0, 0, width, height, background)).isGreaterThan(500);
            }
        }
    }

    /** Where a footnote reaches it, the figure, which shows the view, is not in the rows of the footnotes. */
    @Test
    void theFigureStandsAboveFootnotesThatReachIt() {
        assertThat(rowsOfTheFigure("a very long list of structures, ".repeat(6)))
                .isZero();
        assertThat(rowsOfTheFigure("the skin")).isPositive();
    }

    /** Rows of the footnotes in which a picture differs from one from another side, at the right. */
    private static long rowsOfTheFigure(String notInScan) {
        BufferedImage[] pictures = Stream.of(AnatomicalView.ANTERIOR, AnatomicalView.LEFT)
                .map(view -> {
                    BufferedImage picture = blank(400, 400, 0);
                    Graphics2D g = picture.createGraphics();
                    new Annotations(true, "", "", "", Optional.empty(), notInScan)
                            .drawStatic(g, Camera.of(view, BODY), 400, 400, 1);
                    g.dispose();
                    return picture;
                })
                .toArray(BufferedImage[]::new);
        return IntStream.range(378, 400)
                .filter(y ->
                        IntStream.range(350, 400).anyMatch(x -> pictures[0].getRGB(x, y) != pictures[1].getRGB(x, y)))
                .count();
    }

    /** In the view of a window of 1024 x 768, beside the docks of a rehearsal. */
    @Test
    void whatIsNotInTheScanIsReadWholeInANarrowPicture() {
        String missing = "22 of 24 ribs, 15 of 20 costal cartilages, sternum, diaphragm, 12 vertebrae, skin, the heart";
        Graphics2D g = blank(260, 600, 0).createGraphics();
        HaloGraphics ink = HaloGraphics.over(g, true, 1);
        List<String> lines = ink.lines("Not in the scan: " + missing, 10, 242, 3);
        assertThat(String.join(" ", lines)).isEqualTo("Not in the scan: " + missing);
        assertThat(lines).hasSizeBetween(2, 3).allSatisfy(line -> assertThat(
                        ink.measure(line, 10, false).getWidth())
                .isLessThanOrEqualTo(242));
        assertThat(rowsOfInk(missing)).isGreaterThan(rowsOfInk("the skin"));
        g.dispose();
    }

    /** Rows at the foot of a narrow picture, above the disclaimer, at whose left there is ink. */
    private static long rowsOfInk(String notInScan) {
        BufferedImage picture = blank(260, 600, LIGHT);
        Graphics2D g = picture.createGraphics();
        new Annotations(true, "", "", "", Optional.empty(), notInScan)
                .drawStatic(g, Camera.of(AnatomicalView.ANTERIOR, BODY), 260, 600, 1);
        g.dispose();
        return IntStream.range(520, 580)
                .filter(y -> marked(picture, 8, y, 60, y + 1, LIGHT) > 0)
                .count();
    }

    /** The dock of a rehearsal has the legend of its map; a bar in a narrow picture would lie on the body. */
    @Test
    void theBarIsShortInANarrowPictureAndNotDrawnForTheAccessMap() {
        assertThat(lastRowOfTheBar(700, ColourField.DISPLACEMENT)).isBetween(390, 405);
        assertThat(lastRowOfTheBar(700, ColourField.ACCESS)).isBetween(390, 405);
        assertThat(lastRowOfTheBar(400, ColourField.DISPLACEMENT)).isBetween(270, 285);
        assertThat(lastRowOfTheBar(400, ColourField.ACCESS)).isEqualTo(-1);
    }

    /** The last row that a colour bar changes in a picture 600 pixels high; -1 if it changes none. */
    private static int lastRowOfTheBar(int width, ColourField field) {
        BufferedImage[] pictures = Stream.of(
                        Optional.<ColourScale>empty(), Optional.of(ColourScale.sequential(20, "mm")))
                .map(scale -> {
                    BufferedImage picture = blank(width, 600, LIGHT);
                    Graphics2D g = picture.createGraphics();
                    new Annotations(true, "", "", field.label(), scale, "")
                            .drawStatic(g, Camera.of(AnatomicalView.ANTERIOR, BODY), width, 600, 1);
                    g.dispose();
                    return picture;
                })
                .toArray(BufferedImage[]::new);
        return IntStream.range(0, 600)
                .filter(y ->
                        IntStream.range(0, width).anyMatch(x -> pictures[0].getRGB(x, y) != pictures[1].getRGB(x, y)))
                .max()
                .orElse(-1);
    }

    @Test
    void theSmallestPictureIsDrawnToo() {
        assertThat(annotated(16, 16, true, Camera.of(AnatomicalView.LEFT, BODY)).getWidth())
                .isEqualTo(16);
    }

    @ParameterizedTest
    @EnumSource(AnatomicalView.class)
    void lettersNameTheSidesOfThePicture(AnatomicalView view) {
        Camera camera = Camera.of(view, BODY);
        String expected =
                switch (view) {
                    case ANTERIOR -> "LS";
                    case POSTERIOR -> "RS";
                    case LEFT -> "PS";
                    case RIGHT -> "AS";
                    case SUPERIOR -> "LP";
                    case INFERIOR -> "LA";
                };
        assertThat(PatientOrientation.letters(camera.right()) + PatientOrientation.letters(camera.up()))
                .isEqualTo(expected);
    }

    /** An R has more strokes than an L, and an S than an I. */
    @Test
    void eachLetterStandsAtTheSideThatItNames() {
        BufferedImage picture = plain(400, 400, Camera.of(AnatomicalView.ANTERIOR, BODY));
        long right = ink(picture, 16, 200, 15);
        long left = ink(picture, 384, 200, 15);
        assertThat(left).isPositive();
        assertThat(right).isGreaterThan(left);
        long inferior = ink(picture, 200, 370, 10);
        assertThat(inferior).isPositive();
        assertThat(ink(picture, 200, 16, 10)).isGreaterThan(inferior);
    }

    @Test
    void aSlantedSideHasTwoLettersTheStrongerFirst() {
        Vector3d r = Camera.of(AnatomicalView.ANTERIOR, BODY).orbit(30, 0).right();
        assertThat(PatientOrientation.letters(r)).isEqualTo("LP");
        r = Camera.of(AnatomicalView.ANTERIOR, BODY).orbit(20, 0).right();
        assertThat(PatientOrientation.letters(r)).isEqualTo("L");
    }

    @Test
    void theOppositeOfADirectionHasTheLettersOfTheReversedVector() {
        for (Vector3d d : new Vector3d[] {
            new Vector3d(1, 0, 0), new Vector3d(0, -1, 0), new Vector3d(0, 0, 1), new Vector3d(0.8, -0.6, 0)
        }) {
            assertThat(PatientOrientation.opposite(PatientOrientation.letters(d)))
                    .isEqualTo(PatientOrientation.letters(new Vector3d(d).negate()));
        }
    }

    @Test
    void theRulerIsTheLongestRoundLengthThatFits() {
        assertThat(Ruler.roundLength(0.5, 250)).isEqualTo(100);
        assertThat(Ruler.roundLength(0.5, 190)).isEqualTo(50);
        assertThat(Ruler.roundLength(0.05, 250)).isEqualTo(10);
        assertThat(Ruler.roundLength(0.001, 100)).isZero();
    }

    @Test
    void theRulerIsAsLongAsItSays() {
        Camera camera = Camera.of(AnatomicalView.ANTERIOR, BODY).withProjection(true);
        BufferedImage picture = plain(800, 600, camera);
        int longest = 0;
        for (int y = 450; y < 600; y++) {
            int run = 0;
            for (int x = 0; x < 300; x++) {
                run = isInk(picture, x, y) ? run + 1 : 0;
                longest = Math.max(longest, run);
            }
        }
        double mmPerPixel = camera.mmPerPixel(600);
        double said = Ruler.roundLength(mmPerPixel, 0.25 * 800);
        assertThat(longest * mmPerPixel).isCloseTo(said, within(3 * mmPerPixel));
    }

    /** Row of the pixel whose colour is nearest to one. */
    private static int rowOf(BufferedImage picture, int rgb) {
        double[] colour = components(rgb);
        return IntStream.range(0, picture.getHeight())
                .boxed()
                .min(Comparator.comparingDouble(y -> IntStream.range(0, picture.getWidth())
                        .mapToDouble(x -> Vectors.distance(colour, components(picture.getRGB(x, y))))
                        .min()
                        .orElseThrow()))
                .orElseThrow();
    }

    private static double[] components(int rgb) {
        return new double[] {rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff};
    }

    /** The number of the upper end, 20, has a digit more than that of the lower, 0. */
    @Test
    void coloursAndNumbersOfTheScaleRiseTogether() {
        BufferedImage picture = blank(120, 300, LIGHT);
        Graphics2D g = picture.createGraphics();
        ColourScale scale = ColourScale.sequential(20, "mm");
        ColourBar.draw(HaloGraphics.over(g, true, 1), "", scale, 110, 20, 280);
        g.dispose();
        assertThat(rowOf(picture, scale.map().rgb(1))).isBetween(35, 45);
        assertThat(rowOf(picture, scale.map().rgb(0))).isBetween(274, 281);
        long lower = ink(picture, 104, 280, 7);
        assertThat(lower).isPositive();
        assertThat(ink(picture, 104, 40, 7)).isGreaterThan(lower);
    }

    @Test
    void theScaleShowsItsEndsAndRoundValuesBetween() {
        assertThat(ColourBar.tickValues(ColourScale.sequential(20, "mm"))).containsExactly(0.0, 5.0, 10.0, 15.0, 20.0);
        assertThat(ColourBar.tickValues(ColourScale.diverging(12.5, "%")))
                .containsExactly(-12.5, -10.0, -5.0, 0.0, 5.0, 10.0, 12.5);
        double[] tiny = ColourBar.tickValues(new ColourScale(ColourMap.VIRIDIS, 0.001, 0.0013, "mm")).stream()
                .mapToDouble(Double::doubleValue)
                .toArray();
        assertThat(tiny[1]).isCloseTo(0.0011, within(1e-9));
        assertThat(Arrays.stream(tiny).distinct().count()).isEqualTo(tiny.length);
    }

    @Test
    void lettersCanBeReadOnBothBackgrounds() {
        for (boolean light : new boolean[] {true, false}) {
            BufferedImage p = annotated(640, 480, light, Camera.of(AnatomicalView.ANTERIOR, BODY));
            int strongest = 0;
            for (int y = 0; y < 40; y++) {
                for (int x = 300; x < 340; x++) {
                    strongest =
                            Math.max(strongest, Math.abs((p.getRGB(x, y) & 0xff) - ((light ? LIGHT : DARK) & 0xff)));
                }
            }
            assertThat(strongest).as("contrast of the letter S, of 255").isGreaterThan(180);
        }
    }
}
