package org.phrenic.scene.annotate;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;

/**
 * Writes and draws over a picture so that it can be read on whatever lies below: dark on a light rim, or light on a
 * dark one.
 *
 * @param graphics to draw with
 * @param foreground colour of letters and lines
 * @param halo colour about them
 * @param unit size of everything, pixels; 1 on an ordinary screen
 */
record HaloGraphics(Graphics2D graphics, Color foreground, Color halo, double unit) {
    /** Smallest text that can be read, pixels. */
    private static final float MIN_TEXT_PX = 7;

    static HaloGraphics over(Graphics2D graphics, boolean lightBackground, double unit) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        return lightBackground
                ? new HaloGraphics(g, new Color(0x1d242b), new Color(255, 255, 255, 200), unit)
                : new HaloGraphics(g, new Color(0xe9edf1), new Color(12, 15, 18, 190), unit);
    }

    /** A length of so many units, pixels. */
    double toPixels(double units) {
        return units * unit;
    }

    private GlyphVector glyphVector(String text, double size, boolean bold) {
        Font font = new Font(Font.SANS_SERIF, bold ? Font.BOLD : Font.PLAIN, 1)
                .deriveFont((float) Math.max(MIN_TEXT_PX, toPixels(size)));
        return font.createGlyphVector(graphics.getFontRenderContext(), text);
    }

    /** How wide and high a text becomes, pixels; the height is that of capitals. */
    Rectangle2D measure(String text, double size, boolean bold) {
        return new Rectangle2D.Double(
                0,
                0,
                glyphVector(text, size, bold).getLogicalBounds().getWidth(),
                glyphVector("H", size, bold).getVisualBounds().getHeight());
    }

    /** The greatest size up to {@code size} at which a text is at most {@code width} pixels wide. */
    double fittingSize(String text, double size, double width) {
        double room = Math.max(0, width);
        double needed = measure(text, size, false).getWidth();
        return needed <= room ? size : size * room / needed;
    }

    /** As much of a text as fits into a width at a size, with an ellipsis where it had to be cut. */
    String ellipsized(String text, double size, double width) {
        if (measure(text, size, false).getWidth() <= width) {
            return text;
        }
        int length = text.length();
        while (length > 0
                && measure(text.substring(0, length) + "\u2026", size, false).getWidth() > width) {
            length--;
        }
        return length == 0 ? "" : text.substring(0, length).strip() + "\u2026";
    }

    /**
     * Writes a text.
     *
     * @param x where it begins (align 0), has its middle (0.5) or ends (1), pixels
     * @param baseline on which it stands, pixels
     */
    void drawText(String text, double x, double baseline, double align, double size, boolean bold) {
        GlyphVector glyphs = glyphVector(text, size, bold);
        double left = x - align * glyphs.getLogicalBounds().getWidth();
        fillShape(glyphs.getOutline((float) left, (float) baseline), toPixels(size) / 4.5);
    }

    /** Fills a shape with the front colour on a rim. */
    void fillShape(Shape shape, double rimWidth) {
        graphics.setColor(halo);
        graphics.setStroke(new BasicStroke((float) rimWidth, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.draw(shape);
        graphics.setColor(foreground);
        graphics.fill(shape);
    }

    /** Draws a line of this width in pixels on a rim. */
    void drawLine(Shape path, double width) {
        graphics.setColor(halo);
        graphics.setStroke(new BasicStroke((float) (3 * width), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        graphics.draw(path);
        graphics.setColor(foreground);
        graphics.setStroke(new BasicStroke((float) width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER));
        graphics.draw(path);
    }

    void dispose() {
        graphics.dispose();
    }

    /** A shape somewhere else. */
    static Shape translated(Shape shape, double x, double y) {
        return AffineTransform.getTranslateInstance(x, y).createTransformedShape(shape);
    }
}
