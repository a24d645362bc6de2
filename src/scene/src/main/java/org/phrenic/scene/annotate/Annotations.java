package org.phrenic.scene.annotate;

import java.awt.AWTError;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.Numbers;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;

/**
 * Annotations drawn over a picture of the scene: orientation letters at the edges, an orientation figure, a scale bar
 * (parallel projection only), a colour bar, title and time, the parts that are not in the scan, and the disclaimer.
 *
 * @param lightBackground whether the background of the picture is light
 * @param title title; empty for none
 * @param timestamp time and breathing phase; empty for none
 * @param quantityName name of the quantity that {@code scale} shows
 * @param scale colour scale of the coloured surface
 * @param notInScan parts of the body that do not come from its scan; empty for none
 */
public record Annotations(
        boolean lightBackground,
        String title,
        String timestamp,
        String quantityName,
        Optional<ColourScale> scale,
        String notInScan) {
    private static final double LETTER_SIZE = 17;
    private static final double TEXT_SIZE = 12;
    private static final double SMALL_TEXT_SIZE = 10;
    private static final double MARGIN = 9;
    private static final double FIGURE_HEIGHT = 74;
    /** Width of the figure that is kept clear of footnotes, in heights of it. */
    private static final double FIGURE_WIDTH = 0.6;
    /** Shorter side of the picture at which one unit is one pixel, pixels. */
    private static final double REFERENCE_SIDE = 720;

    private static final double MIN_UNIT = 0.62;
    /** Maximum length of the scale bar, as a fraction of the picture width. */
    private static final double MAX_RULER_SHARE = 0.25;

    /** Lines at most of the parts that are not in the scan. */
    private static final int MOST_LINES = 3;
    /**
     * Width below which the colour bar would lie on the body: half as high a bar stands above it, and none for the
     * access map, whose legend is a part of its controls.
     */
    private static final double NARROW = 500;

    /** Ends of the colour bar, as fractions of the picture height. */
    private static final double BAR_BEGIN = 0.26;

    private static final double BAR_END = 0.66;
    private static final double NARROW_BAR_END = 0.46;

    /** Annotations for a style, without title and time. */
    public static Annotations of(SceneStyle style) {
        return new Annotations(
                style.background() == SceneBackground.LIGHT,
                "",
                "",
                style.field().label(),
                style.field() == ColourField.NONE ? Optional.empty() : Optional.of(style.scale()),
                "");
    }

    public Annotations withTitle(String text) {
        return new Annotations(lightBackground, text, timestamp, quantityName, scale, notInScan);
    }

    /** Copy with a line of time and breathing phase. */
    public Annotations withTimestamp(String text) {
        return new Annotations(lightBackground, title, text, quantityName, scale, notInScan);
    }

    /** Copy that names the parts of the body that do not come from its scan. */
    public Annotations withNotInScan(String parts) {
        return new Annotations(lightBackground, title, timestamp, quantityName, scale, parts);
    }

    /** Formats time and breathing phase: "1.25 s, inspiration". */
    public static String timestamp(double timeS, String phase) {
        return Numbers.format("%.2f s%s", timeS, phase.isEmpty() ? "" : ", " + phase);
    }

    /** Tests once whether this Java runtime has fonts, which text needs. */
    private static final class Fonts {
        private static final boolean AVAILABLE = available();

        private static boolean available() {
            try {
                Graphics2D g = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB).createGraphics();
                HaloGraphics.over(g, true, 1).drawText("R", 1, 7, 0, TEXT_SIZE, false);
                g.dispose();
                return true;
            } catch (LinkageError | RuntimeException | InternalError | AWTError none) {
                return false;
            }
        }
    }

    public static boolean hasFonts() {
        return Fonts.AVAILABLE;
    }

    /** Draws over a picture. Does nothing in a Java runtime without fonts. */
    public void draw(BufferedImage picture, Camera camera) {
        if (hasFonts()) {
            Graphics2D g = picture.createGraphics();
            int width = picture.getWidth();
            int height = picture.getHeight();
            double unit = Math.max(MIN_UNIT, Math.min(width, height) / REFERENCE_SIDE);
            drawHeading(g, camera, width, height, unit);
            drawStatic(g, camera, width, height, unit);
            g.dispose();
        }
    }

    /**
     * Draws title and time, which change with every frame.
     *
     * @param graphics graphics with the origin at the top left corner of the picture
     * @param width width of the picture, in pixels of {@code graphics}
     * @param height height of the picture, in pixels of {@code graphics}
     * @param unit scale factor of text and lines, 1 for a window
     */
    public void drawHeading(Graphics2D graphics, Camera camera, int width, int height, double unit) {
        if (!title.isEmpty() || !timestamp.isEmpty()) {
            HaloGraphics ink = halo(graphics, width, height, unit);
            drawTitleAndTime(ink, width, rightLetterWidth(ink, camera));
            ink.dispose();
        }
    }

    /** Draws all annotations except title and time, like {@link #drawHeading}. They do not depend on the frame. */
    public void drawStatic(Graphics2D graphics, Camera camera, int width, int height, double unit) {
        HaloGraphics ink = halo(graphics, width, height, unit);
        double margin = ink.toPixels(MARGIN);
        double small = ink.measure("H", SMALL_TEXT_SIZE, false).getHeight();
        double line = small + ink.toPixels(5);
        List<String> missing = notInScan.isEmpty()
                ? List.of()
                : ink.lines("Not in the scan: " + notInScan, SMALL_TEXT_SIZE, width - 2 * margin, MOST_LINES);
        double floor = height - margin - small - ink.toPixels(7) - missing.size() * line;
        drawOrientationLetters(ink, camera, width, height, floor);
        double notes = drawFootnote(ink, Disclaimer.TEXT, width, height - margin);
        for (int i = 0; i < missing.size(); i++) {
            double baseline = height - margin - (missing.size() - i) * line;
            notes = Math.max(notes, drawFootnote(ink, missing.get(i), width, baseline));
        }
        double figure = Math.min(ink.toPixels(FIGURE_HEIGHT), 0.3 * Math.min(width, height));
        boolean above = notes > width - margin - figure * FIGURE_WIDTH;
        double foot = above ? floor : height - margin;
        OrientationFigure.draw(ink, camera, width - margin - figure * 0.36, foot - figure * 0.52, figure);
        if (camera.orthographic()) {
            Ruler.draw(ink, camera.mmPerPixel(height), margin, floor, MAX_RULER_SHARE * width);
        }
        boolean narrow = width < ink.toPixels(NARROW);
        boolean hidden = narrow && quantityName.equals(ColourField.ACCESS.label());
        scale.filter(colours -> !hidden).ifPresent(colours -> {
            double lowest = height * (narrow ? NARROW_BAR_END : BAR_END);
            double bottom = Math.min(lowest, foot - 1.1 * figure - ink.toPixels(8));
            double right = width - margin - rightLetterWidth(ink, camera) - ink.toPixels(8);
            ColourBar.draw(ink, quantityName, colours, right, height * BAR_BEGIN, bottom);
        });
        ink.dispose();
    }

    /** Draws a line at the foot, and returns where it ends, pixels from the left. */
    private static double drawFootnote(HaloGraphics ink, String text, int width, double baseline) {
        double margin = ink.toPixels(MARGIN);
        double size = ink.fittingSize(text, SMALL_TEXT_SIZE, width - 2 * margin);
        String shown = ink.ellipsized(text, size, width - 2 * margin);
        ink.drawText(shown, margin, baseline, 0, size, false);
        return margin + ink.measure(shown, size, false).getWidth();
    }

    private HaloGraphics halo(Graphics2D graphics, int width, int height, double unit) {
        double most = Math.max(MIN_UNIT, Math.min(width, height) / 200.0);
        return HaloGraphics.over(graphics, lightBackground, Math.min(unit, most));
    }

    private static double rightLetterWidth(HaloGraphics ink, Camera camera) {
        String letters = PatientOrientation.letters(camera.right());
        return ink.measure(letters, LETTER_SIZE, true).getWidth();
    }

    private static void drawOrientationLetters(HaloGraphics ink, Camera camera, int width, int height, double floor) {
        Vector3d right = camera.right();
        Vector3d up = camera.up();
        double capHeight = ink.measure("H", LETTER_SIZE, true).getHeight();
        double margin = ink.toPixels(MARGIN);
        double middle = (height + capHeight) / 2;
        drawLetters(ink, right, width - margin, middle, 1);
        drawLetters(ink, right.negate(), margin, middle, 0);
        drawLetters(ink, up, width / 2.0, margin + capHeight, 0.5);
        drawLetters(ink, up.negate(), width / 2.0, floor, 0.5);
    }

    private static void drawLetters(HaloGraphics ink, Vector3d direction, double x, double baseline, double align) {
        ink.drawText(PatientOrientation.letters(direction), x, baseline, align, LETTER_SIZE, true);
    }

    /** Draws title and time at the top left, clear of the letter in the middle. */
    private void drawTitleAndTime(HaloGraphics ink, int width, double letters) {
        double margin = ink.toPixels(MARGIN);
        double room = width / 2.0 - margin - letters / 2 - ink.toPixels(8);
        double baseline = margin;
        for (String text : new String[] {title, timestamp}) {
            if (!text.isEmpty()) {
                double size = ink.fittingSize(text, TEXT_SIZE, room);
                baseline += ink.measure("H", TEXT_SIZE, false).getHeight();
                ink.drawText(ink.ellipsized(text, size, room), margin, baseline, 0, size, false);
                baseline += ink.toPixels(7);
            }
        }
    }
}
