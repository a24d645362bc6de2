package org.phrenic.scene.annotate;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.GlyphVector;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Draws text and lines with a contrasting halo, which keeps them legible over any picture.
 *
 * @param graphics target of the drawing
 * @param foreground colour of text and lines
 * @param halo colour around them
 * @param unit pixels per unit of length; 1 on a screen
 */
record HaloGraphics(Graphics2D graphics, Color foreground, Color halo, double unit) {
    /** Smallest legible text size, pixels. */
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

    double toPixels(double units) {
        return units * unit;
    }

    private GlyphVector glyphVector(String text, double size, boolean bold) {
        Font font = new Font(Font.SANS_SERIF, bold ? Font.BOLD : Font.PLAIN, 1);
        float pixels = (float) Math.max(MIN_TEXT_PX, toPixels(size));
        return font.deriveFont(pixels).createGlyphVector(graphics.getFontRenderContext(), text);
    }

    /** Width of a text and height of capital letters, pixels. */
    Rectangle2D measure(String text, double size, boolean bold) {
        double width = glyphVector(text, size, bold).getLogicalBounds().getWidth();
        return new Rectangle2D.Double(
                0, 0, width, glyphVector("H", size, bold).getVisualBounds().getHeight());
    }

    /** The largest font size, at most {@code size}, at which a text is at most {@code width} pixels wide. */
    double fittingSize(String text, double size, double width) {
        double room = Math.max(0, width);
        double needed = measure(text, size, false).getWidth();
        return needed <= room ? size : size * room / needed;
    }

    /** Shortens a text to a width in pixels; a shortened text ends in an ellipsis. */
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

    /** Breaks a text between words into lines of a width in pixels; the last line takes what is left. */
    List<String> lines(String text, double size, double width, int most) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : text.split(" ", -1)) {
            String longer = line.isEmpty() ? word : line + " " + word;
            boolean full = measure(longer, size, false).getWidth() > width;
            if (full && !line.isEmpty() && lines.size() < most - 1) {
                lines.add(line);
                longer = word;
            }
            line = longer;
        }
        lines.add(line);
        return lines;
    }

    /**
     * Draws a text.
     *
     * @param x anchor, pixels: left end (align 0), centre (0.5) or right end (1)
     * @param baseline y of the baseline, pixels
     */
    void drawText(String text, double x, double baseline, double align, double size, boolean bold) {
        GlyphVector glyphs = glyphVector(text, size, bold);
        double left = x - align * glyphs.getLogicalBounds().getWidth();
        fillShape(glyphs.getOutline((float) left, (float) baseline), toPixels(size) / 4.5);
    }

    void fillShape(Shape shape, double haloWidth) {
        stroke(shape, halo, haloWidth, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        graphics.setColor(foreground);
        graphics.fill(shape);
    }

    /** Draws a path with a line width in pixels and a halo. */
    void drawLine(Shape path, double width) {
        stroke(path, halo, 3 * width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        stroke(path, foreground, width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER);
    }

    private void stroke(Shape shape, Color colour, double width, int cap, int join) {
        graphics.setColor(colour);
        graphics.setStroke(new BasicStroke((float) width, cap, join));
        graphics.draw(shape);
    }

    void dispose() {
        graphics.dispose();
    }
}
