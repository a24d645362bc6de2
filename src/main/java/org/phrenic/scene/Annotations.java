package org.phrenic.scene;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.Optional;

/**
 * What is written over a picture of the scene, in a window and without one alike: letters of orientation at the edges, a figure that stands as the patient does, a ruler in parallel projection, the scale
 * of a coloured surface, what is shown and when, and the notice.
 *
 * @param lightBackground whether the picture is light
 * @param title what is shown; empty for nothing
 * @param moment time and phase; empty for nothing
 * @param fieldName what colours show, with {@code scale}
 * @param scale of a coloured surface
 */
public record Annotations(
        boolean lightBackground, String title, String moment, String fieldName, Optional<ColourScale> scale) {
    /** On the first screen, in every report and on every picture. */
    public static final String NOTICE = org.phrenic.format.Notice.TEXT;

    private static final double LETTER = 17;
    private static final double TEXT = 12;
    private static final double SMALL = 10;
    private static final double MARGIN = 9;
    private static final double FIGURE = 74;
    /** The picture for which a unit is one pixel, pixels on its shorter side. */
    private static final double ORDINARY = 720;

    private static final double LEAST_UNIT = 0.62;
    /** The longest ruler, a share of the width. */
    private static final double RULER = 0.25;

    /** Letters, figure, notice and ruler alone. */
    public static Annotations on(boolean lightBackground) {
        return new Annotations(lightBackground, "", "", "", Optional.empty());
    }

    /** The same with a title. */
    public Annotations withTitle(String text) {
        return new Annotations(lightBackground, text, moment, fieldName, scale);
    }

    /** The same with a line about the time. */
    public Annotations withMoment(String text) {
        return new Annotations(lightBackground, title, text, fieldName, scale);
    }

    /** The same with the scale of a coloured surface. */
    public Annotations withScale(String name, ColourScale colours) {
        return new Annotations(lightBackground, title, moment, name, Optional.of(colours));
    }

    /** Time and what the breath is doing: "1.25 s, inspiration". */
    public static String moment(double timeS, String phase) {
        return String.format(Locale.ROOT, "%.2f s%s", timeS, phase.isEmpty() ? "" : ", " + phase);
    }

    /** Size of letters and lines for a picture to be kept: they grow with it. */
    public static double unitOfPicture(int width, int height) {
        return Math.max(LEAST_UNIT, Math.min(width, height) / ORDINARY);
    }

    /** Whether this machine can write letters at all: a Java without fonts cannot. */
    public static boolean canWrite() {
        try {
            Graphics2D g = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB).createGraphics();
            Ink ink = Ink.on(g, true, 1);
            ink.text("R", 1, 7, 0, TEXT, false);
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
            draw(
                    g,
                    camera,
                    picture.getWidth(),
                    picture.getHeight(),
                    unitOfPicture(picture.getWidth(), picture.getHeight()));
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
        drawMarks(graphics, camera, width, height, unit);
    }

    /** Of {@link #draw(Graphics2D, Camera, int, int, double)} title and moment alone, which change with every frame. */
    public void drawHeading(Graphics2D graphics, Camera camera, int width, int height, double unit) {
        if (!title.isEmpty() || !moment.isEmpty()) {
            Ink ink = ink(graphics, width, height, unit);
            heading(ink, width, widthAtRight(ink, camera));
            ink.dispose();
        }
    }

    /** Of {@link #draw(Graphics2D, Camera, int, int, double)} all but title and moment: what stays while the camera does. */
    public void drawMarks(Graphics2D graphics, Camera camera, int width, int height, double unit) {
        Ink ink = ink(graphics, width, height, unit);
        double margin = ink.px(MARGIN);
        double small = ink.measure("H", SMALL, false).getHeight();
        double floor = height - margin - small - ink.px(7);
        letters(ink, camera, width, height, floor);
        double size = ink.fitted(NOTICE, SMALL, width - 2 * margin);
        ink.text(ink.shortened(NOTICE, size, width - 2 * margin), margin, height - margin, 0, size, false);
        double figure = Math.min(ink.px(FIGURE), 0.3 * Math.min(width, height));
        OrientationFigure.draw(ink, camera, width - margin - figure * 0.36, height - margin - figure * 0.52, figure);
        if (camera.orthographic()) {
            Ruler.draw(ink, camera.mmPerPixel(height), margin, floor, RULER * width);
        }
        scale.ifPresent(colours -> {
            double bottom = Math.min(height * 0.66, height - margin - 1.1 * figure - ink.px(8));
            double right = width - margin - widthAtRight(ink, camera) - ink.px(8);
            ScaleBar.draw(ink, fieldName, colours, right, height * 0.26, bottom);
        });
        ink.dispose();
    }

    private Ink ink(Graphics2D graphics, int width, int height, double unit) {
        return Ink.on(graphics, lightBackground, Math.min(unit, Math.max(LEAST_UNIT, Math.min(width, height) / 200.0)));
    }

    /** Width of the letters at the right edge, pixels. */
    private static double widthAtRight(Ink ink, Camera camera) {
        double[] r = camera.right();
        return ink.measure(Orientation.letters(r[0], r[1], r[2]), LETTER, true).getWidth();
    }

    /** Letters in the middle of the edges. */
    private static void letters(Ink ink, Camera camera, int width, int height, double floor) {
        double[] r = camera.right();
        double[] u = camera.up();
        double tall = ink.measure("H", LETTER, true).getHeight();
        double margin = ink.px(MARGIN);
        String right = Orientation.letters(r[0], r[1], r[2]);
        String left = Orientation.letters(-r[0], -r[1], -r[2]);
        double middle = (height + tall) / 2;
        ink.text(right, width - margin, middle, 1, LETTER, true);
        ink.text(left, margin, middle, 0, LETTER, true);
        ink.text(Orientation.letters(u[0], u[1], u[2]), width / 2.0, margin + tall, 0.5, LETTER, true);
        ink.text(Orientation.letters(-u[0], -u[1], -u[2]), width / 2.0, floor, 0.5, LETTER, true);
    }

    /** Title and moment at the top left, clear of the letter in the middle. */
    private void heading(Ink ink, int width, double letters) {
        double margin = ink.px(MARGIN);
        double room = width / 2.0 - margin - letters / 2 - ink.px(8);
        double baseline = margin;
        for (String text : new String[] {title, moment}) {
            if (!text.isEmpty()) {
                double size = ink.fitted(text, TEXT, room);
                baseline += ink.measure("H", TEXT, false).getHeight();
                ink.text(ink.shortened(text, size, room), margin, baseline, 0, size, false);
                baseline += ink.px(7);
            }
        }
    }
}
