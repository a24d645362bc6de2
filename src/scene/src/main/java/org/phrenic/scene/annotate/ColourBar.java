package org.phrenic.scene.annotate;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import org.phrenic.file.Numbers;
import org.phrenic.scene.style.ColourScale;

/** A vertical colour bar with name, unit, and ticks at both ends and at round values. */
final class ColourBar {
    private static final double WIDTH = 14;
    private static final double TEXT_SIZE = 11;
    private static final double GAP = 5;
    private static final int MAX_TICKS = 5;
    /** Minimum distance of two tick labels, in text heights. */
    private static final double MIN_TICK_SPACING = 1.9;

    private ColourBar() {}

    /**
     * Draws the colour bar.
     *
     * @param right right edge of the tick labels, pixels
     * @param top upper edge of the name, pixels
     * @param bottom lower edge of the bar, pixels
     */
    static void draw(HaloGraphics ink, String name, ColourScale scale, double right, double top, double bottom) {
        List<Double> values = tickValues(scale);
        String pattern = numberPattern(values);
        double textHeight = ink.measure("0", TEXT_SIZE, false).getHeight();
        ToDoubleFunction<Double> width =
                v -> ink.measure(text(pattern, v), TEXT_SIZE, false).getWidth();
        double numbers = values.stream().mapToDouble(width).max().orElseThrow();
        double left = right - numbers - ink.toPixels(GAP) - ink.toPixels(WIDTH);
        double barTop = top + textHeight + ink.toPixels(2 * GAP);
        String title = scale.unit().isEmpty() ? name : name + ", " + scale.unit();
        double size = ink.fittingSize(title, TEXT_SIZE, right - ink.toPixels(GAP));
        ink.drawText(ink.ellipsized(title, size, right - ink.toPixels(GAP)), right, top + textHeight, 1, size, false);
        Rectangle2D bar = new Rectangle2D.Double(left, barTop, ink.toPixels(WIDTH), bottom - barTop);
        ink.fillShape(bar, ink.toPixels(3));
        Graphics2D g = ink.graphics();
        int rows = (int) Math.ceil(bar.getHeight());
        for (int i = 0; i < rows; i++) {
            g.setColor(new Color(scale.map().rgb(1 - (i + 0.5) / rows)));
            g.fill(new Rectangle2D.Double(left, barTop + i, bar.getWidth(), Math.min(1, bottom - barTop - i)));
        }
        double free = Double.POSITIVE_INFINITY;
        for (int i = 0; i < values.size(); i++) {
            double y = bottom - scale.fraction(values.get(i)) * bar.getHeight();
            boolean end = i == 0 || i == values.size() - 1;
            double room = Math.min(Math.abs(y - free), Math.min(bottom - y, y - barTop));
            if (!end && room < MIN_TICK_SPACING * textHeight) {
                continue;
            }
            free = end ? free : y;
            ink.drawText(text(pattern, values.get(i)), right, y + textHeight / 2, 1, TEXT_SIZE, false);
            g.setColor(ink.foreground());
            g.setStroke(new BasicStroke((float) Math.max(1, ink.toPixels(1))));
            g.draw(new Line2D.Double(left + bar.getWidth(), y, left + bar.getWidth() + ink.toPixels(3), y));
        }
    }

    /** Tick values: both ends of the range and the round values between them. */
    static List<Double> tickValues(ColourScale scale) {
        double step = tickStep(scale.max() - scale.min());
        List<Double> values = new ArrayList<>();
        values.add(scale.min());
        for (double i = Math.ceil(scale.min() / step); i * step < scale.max(); i++) {
            if (i * step > scale.min()) {
                // Adding 0.0 turns -0.0 into 0.0.
                values.add(i * step + 0.0);
            }
        }
        values.add(scale.max());
        return values;
    }

    /** Tick distance: 1, 2 or 5 times a power of ten, with at most five steps in the range. */
    private static double tickStep(double range) {
        double power = Math.pow(10, Math.floor(Math.log10(range / MAX_TICKS)));
        DoubleStream steps = DoubleStream.of(power, 2 * power, 5 * power);
        return steps.filter(step -> range / step <= MAX_TICKS).findFirst().orElse(10 * power);
    }

    /** Number format with enough decimals to distinguish all values. */
    private static String numberPattern(List<Double> values) {
        double largest = values.stream().mapToDouble(Math::abs).max().orElse(1);
        if (largest >= 1e6 || largest < 1e-4) {
            return "%.2e";
        }
        for (int decimals = 0; decimals < 6; decimals++) {
            double scale = Math.pow(10, decimals);
            double slack = 1e-3 * scale * largest / 100;
            if (values.stream().allMatch(v -> Math.abs(v * scale - Math.rint(v * scale)) < slack)) {
                return "%." + decimals + "f";
            }
        }
        return "%.3g";
    }

    private static String text(String pattern, double value) {
        String text = Numbers.format(pattern, value);
        return text.startsWith("-") ? "\u2212" + text.substring(1) : text;
    }
}
