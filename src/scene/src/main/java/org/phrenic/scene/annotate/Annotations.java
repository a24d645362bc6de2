package org.phrenic.scene.annotate;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.ColourScale;

/**
 * What is written over a picture of the scene, in a window and without one alike: letters of orientation at the edges,
 * a figure that stands as the patient does, a ruler in parallel projection, the scale of a coloured surface, what is
 * shown and when, and the notice.
 *
 * @param lightBackground whether the picture is light
 * @param title what is shown; empty for nothing
 * @param timestamp time and phase; empty for nothing
 * @param quantityName what colours show, with {@code scale}
 * @param scale of a coloured surface
 */
public record Annotations(
        boolean lightBackground, String title, String timestamp, String quantityName, Optional<ColourScale> scale) {
    /** On the first screen, in every report and on every picture. */
    public static final String NOTICE = org.phrenic.document.report.Disclaimer.TEXT;

    private static final double LETTER_SIZE = 17;
    private static final double TEXT_SIZE = 12;
    private static final double SMALL_TEXT_SIZE = 10;
    private static final double MARGIN = 9;
    private static final double FIGURE_HEIGHT = 74;
    /** The picture for which a unit is one pixel, pixels on its shorter side. */
    private static final double REFERENCE_SIDE = 720;

    private static final double MIN_UNIT = 0.62;
    /** The longest ruler, a share of the width. */
    private static final double MAX_RULER_SHARE = 0.25;

    /** Letters, figure, notice and ruler alone. */
    public static Annotations forBackground(boolean lightBackground) {
        return new Annotations(lightBackground, "", "", "", Optional.empty());
    }

    /** The same with a title. */
    public Annotations withTitle(String text) {
        return new Annotations(lightBackground, text, timestamp, quantityName, scale);
    }

    /** The same with a line about the time. */
    public Annotations withTimestamp(String text) {
        return new Annotations(lightBackground, title, text, quantityName, scale);
    }

    /** The same with the scale of a coloured surface. */
    public Annotations withScale(String name, ColourScale colours) {
        return new Annotations(lightBackground, title, timestamp, name, Optional.of(colours));
    }

    /** Time and what the breath is doing: "1.25 s, inspiration". */
    public static String timestamp(double timeS, String phase) {
        return String.format(Locale.ROOT, "%.2f s%s", timeS, phase.isEmpty() ? "" : ", " + phase);
    }

    /** Size of letters and lines for a picture to be kept: they grow with it. */
    public static double unitFor(int width, int height) {
        return Math.max(MIN_UNIT, Math.min(width, height) / REFERENCE_SIDE);
    }

    /** Whether this machine can write letters at all: a Java without fonts cannot. */
    public static boolean hasFonts() {
        try {
            Graphics2D g = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB).createGraphics();
            HaloGraphics ink = HaloGraphics.over(g, true, 1);
            ink.drawText("R", 1, 7, 0, TEXT_SIZE, false);
            ink.dispose();
            g.dispose();
            return true;
        } catch (LinkageError | RuntimeException | InternalError none) {
            return false;
        }
    }

    /** Writes over a picture to be kept. */
    public void draw(BufferedImage picture, Camera camera) {
        Graphics2D g = picture.createGraphics();
        try {
            draw(g, camera, picture.getWidth(), picture.getHeight(), unitFor(picture.getWidth(), picture.getHeight()));
        } finally {
            g.dispose();
        }
    }

    /**
     * Writes over a picture.
     *
     * @param graphics with the origin at its top left corner
     * @param width of the picture, in pixels of {@code graphics}
     * @param height as above
     * @param unit size of letters and lines, 1 for a window
     */
    public void draw(Graphics2D graphics, Camera camera, int width, int height, double unit) {
        drawHeading(graphics, camera, width, height, unit);
        drawStatic(graphics, camera, width, height, unit);
    }

    /** Of {@link #draw(Graphics2D, Camera, int, int, double)} title and moment alone, which change with every frame. */
    public void drawHeading(Graphics2D graphics, Camera camera, int width, int height, double unit) {
        if (!title.isEmpty() || !timestamp.isEmpty()) {
            HaloGraphics ink = halo(graphics, width, height, unit);
            drawTitleAndTime(ink, width, rightLetterWidth(ink, camera));
            ink.dispose();
        }
    }

    /**
     * Of {@link #draw(Graphics2D, Camera, int, int, double)} all but title and moment: what stays while the camera
     * does.
     */
    public void drawStatic(Graphics2D graphics, Camera camera, int width, int height, double unit) {
        HaloGraphics ink = halo(graphics, width, height, unit);
        double margin = ink.toPixels(MARGIN);
        double small = ink.measure("H", SMALL_TEXT_SIZE, false).getHeight();
        double floor = height - margin - small - ink.toPixels(7);
        drawOrientationLetters(ink, camera, width, height, floor);
        double size = ink.fittingSize(NOTICE, SMALL_TEXT_SIZE, width - 2 * margin);
        ink.drawText(ink.ellipsized(NOTICE, size, width - 2 * margin), margin, height - margin, 0, size, false);
        double figure = Math.min(ink.toPixels(FIGURE_HEIGHT), 0.3 * Math.min(width, height));
        OrientationFigure.draw(ink, camera, width - margin - figure * 0.36, height - margin - figure * 0.52, figure);
        if (camera.orthographic()) {
            Ruler.draw(ink, camera.mmPerPixel(height), margin, floor, MAX_RULER_SHARE * width);
        }
        scale.ifPresent(colours -> {
            double bottom = Math.min(height * 0.66, height - margin - 1.1 * figure - ink.toPixels(8));
            double right = width - margin - rightLetterWidth(ink, camera) - ink.toPixels(8);
            ColourBar.draw(ink, quantityName, colours, right, height * 0.26, bottom);
        });
        ink.dispose();
    }

    private HaloGraphics halo(Graphics2D graphics, int width, int height, double unit) {
        return HaloGraphics.over(
                graphics, lightBackground, Math.min(unit, Math.max(MIN_UNIT, Math.min(width, height) / 200.0)));
    }

    /** Width of the letters at the right edge, pixels. */
    private static double rightLetterWidth(HaloGraphics ink, Camera camera) {
        double[] r = camera.right();
        return ink.measure(PatientOrientation.letters(r[0], r[1], r[2]), LETTER_SIZE, true)
                .getWidth();
    }

    /** Letters in the middle of the edges. */
    private static void drawOrientationLetters(HaloGraphics ink, Camera camera, int width, int height, double floor) {
        double[] r = camera.right();
        double[] u = camera.up();
        double tall = ink.measure("H", LETTER_SIZE, true).getHeight();
        double margin = ink.toPixels(MARGIN);
        String right = PatientOrientation.letters(r[0], r[1], r[2]);
        String left = PatientOrientation.letters(-r[0], -r[1], -r[2]);
        double middle = (height + tall) / 2;
        ink.drawText(right, width - margin, middle, 1, LETTER_SIZE, true);
        ink.drawText(left, margin, middle, 0, LETTER_SIZE, true);
        ink.drawText(PatientOrientation.letters(u[0], u[1], u[2]), width / 2.0, margin + tall, 0.5, LETTER_SIZE, true);
        ink.drawText(PatientOrientation.letters(-u[0], -u[1], -u[2]), width / 2.0, floor, 0.5, LETTER_SIZE, true);
    }

    /** Title and moment at the top left, clear of the letter in the middle. */
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
