package org.phrenic.scene;

import java.awt.Color;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The colours of a scale as an upright bar with its range, round values between, name and unit. */
final class ScaleBar {
    private static final double WIDTH = 14;
    private static final double TEXT = 11;
    private static final double GAP = 5;
    private static final int MOST_TICKS = 5;
    /** Room between two numbers, in their heights. */
    private static final double BETWEEN = 1.9;

    private ScaleBar() {}

    /**
     * Draws it.
     *
     * @param right edge that its numbers reach, pixels
     * @param top edge of the name above it, pixels
     * @param bottom edge of the bar, pixels
     */
    static void draw(Ink ink, String name, ColourScale scale, double right, double top, double bottom) {
        List<Double> values = values(scale);
        String pattern = pattern(values);
        double textHeight = ink.measure("0", TEXT, false).getHeight();
        double numbers = values.stream()
                .mapToDouble(v -> ink.measure(text(pattern, v), TEXT, false).getWidth())
                .max()
                .orElseThrow();
        double left = right - numbers - ink.px(GAP) - ink.px(WIDTH);
        double barTop = top + textHeight + ink.px(2 * GAP);
        String title = scale.unit().isEmpty() ? name : name + ", " + scale.unit();
        double size = ink.fitted(title, TEXT, right - ink.px(GAP));
        ink.text(ink.shortened(title, size, right - ink.px(GAP)), right, top + textHeight, 1, size, false);
        Rectangle2D bar = new Rectangle2D.Double(left, barTop, ink.px(WIDTH), bottom - barTop);
        ink.shape(bar, ink.px(3));
        int rows = (int) Math.ceil(bar.getHeight());
        for (int i = 0; i < rows; i++) {
            ink.graphics().setColor(new Color(scale.map().rgb(1 - (i + 0.5) / rows)));
            ink.graphics()
                    .fill(new Rectangle2D.Double(left, barTop + i, bar.getWidth(), Math.min(1, bottom - barTop - i)));
        }
        double free = Double.POSITIVE_INFINITY;
        for (int i = 0; i < values.size(); i++) {
            double y = bottom - scale.share(values.get(i)) * bar.getHeight();
            boolean end = i == 0 || i == values.size() - 1;
            double lowEnd = bottom - y;
            double highEnd = y - barTop;
            if (!end && Math.min(lowEnd, highEnd) < BETWEEN * textHeight) {
                continue;
            }
            if (!end && Math.abs(y - free) < BETWEEN * textHeight) {
                continue;
            }
            free = end ? free : y;
            ink.text(text(pattern, values.get(i)), right, y + textHeight / 2, 1, TEXT, false);
            ink.graphics().setColor(ink.front());
            ink.graphics().setStroke(new java.awt.BasicStroke((float) Math.max(1, ink.px(1))));
            ink.graphics().draw(new Line2D.Double(left + bar.getWidth(), y, left + bar.getWidth() + ink.px(3), y));
        }
    }

    /** Both ends of the range and the round values within. */
    static List<Double> values(ColourScale scale) {
        double step = step(scale.max() - scale.min());
        List<Double> values = new ArrayList<>();
        values.add(scale.min());
        for (double i = Math.ceil(scale.min() / step); i * step < scale.max(); i++) {
            if (i * step > scale.min()) {
                // 0.0 and not -0.0.
                values.add(i * step + 0.0);
            }
        }
        values.add(scale.max());
        return values;
    }

    /** 1, 2 or 5 times a power of ten, so that a range has at most five of them. */
    private static double step(double range) {
        double power = Math.pow(10, Math.floor(Math.log10(range / MOST_TICKS)));
        for (double times : new double[] {1, 2, 5}) {
            if (range / (times * power) <= MOST_TICKS) {
                return times * power;
            }
        }
        return 10 * power;
    }

    /** As many decimals as it takes to tell all values. */
    private static String pattern(List<Double> values) {
        double largest = values.stream().mapToDouble(Math::abs).max().orElse(1);
        if (largest >= 1e6 || largest < 1e-4) {
            return "%.2e";
        }
        for (int decimals = 0; decimals < 6; decimals++) {
            double scale = Math.pow(10, decimals);
            if (values.stream()
                    .allMatch(v -> Math.abs(v * scale - Math.rint(v * scale)) < 1e-3 * scale * largest / 100)) {
                return "%." + decimals + "f";
            }
        }
        return "%.3g";
    }

    private static String text(String pattern, double value) {
        String text = String.format(Locale.ROOT, pattern, value);
        return text.startsWith("-") ? "\u2212" + text.substring(1) : text;
    }
}
