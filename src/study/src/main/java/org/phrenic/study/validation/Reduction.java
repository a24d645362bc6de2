package org.phrenic.study.validation;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.study.BreathSeries;

/**
 * Reductions of a time series to one number. Changes are from end-expiration to end-inspiration of a breath, averaged
 * over complete breaths ({@link BreathSeries}).
 */
public enum Reduction {
    /** Value at end-expiration. */
    START,
    /** Value at end-inspiration. */
    END,
    /** Change. */
    RISE,
    /** Negative change: a fall is positive. */
    FALL,
    /** Absolute value of the change. */
    SIZE,
    /** Fall in per cent of the value at end-expiration. */
    PERCENT_FALL,
    /**
     * Smallest difference of absolute changes between consecutive observables of a list; positive if the absolute
     * changes are in descending order.
     */
    ORDER,
    /** Absolute change divided by that of another observable, which may be taken from another preset. */
    RATIO,
    /**
     * Absolute slope of an observable over another in inspiration, by least squares between 15 and 87 % of the other's
     * change (Houston et al. 1994).
     */
    SLOPE,
    /**
     * Absolute change at the time in inspiration at which another observable first reaches a given share of its own
     * change, in this preset or another.
     */
    AT_SHARE,
    /** Change from end-inspiration to the end of a hold. */
    CREEP,
    /** Largest difference between inspiration and expiration at equal values of another observable. */
    HYSTERESIS;

    private static final double SLOPE_FROM = 0.15;
    private static final double SLOPE_TO = 0.87;
    private static final int HYSTERESIS_LEVELS = 50;

    /** Label used in the table. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The constant of a label; empty if the label is unknown. */
    public static Optional<Reduction> of(String label) {
        return Arrays.stream(values()).filter(r -> r.label().equals(label)).findFirst();
    }

    /** All labels. */
    public static List<String> labels() {
        return Arrays.stream(values()).map(Reduction::label).toList();
    }

    /** Whether the reduction needs a second observable. */
    public boolean needsSecondObservable() {
        return this == RATIO || this == SLOPE || this == AT_SHARE || this == HYSTERESIS;
    }

    /** Whether the second observable may be that of another preset. */
    boolean readsSecondPreset() {
        return this == RATIO || this == AT_SHARE;
    }

    /**
     * Computes the reduction.
     *
     * @param series of the preset
     * @param other series of the other preset; {@code series} if none is named
     * @param observables one; at least two for {@link #ORDER}
     * @param against second observable, where it {@linkplain #needsSecondObservable() is needed}
     * @param share for {@link #AT_SHARE}
     * @return the reduced value; NaN if the series does not contain it
     */
    public double of(BreathSeries series, BreathSeries other, List<String> observables, String against, double share) {
        String x = observables.get(0);
        return switch (this) {
            case START -> series.meanAtEndExpiration(x);
            case END -> series.meanAtEndInspiration(x);
            case RISE -> series.meanChange(x);
            case FALL -> -series.meanChange(x);
            case SIZE -> Math.abs(series.meanChange(x));
            case PERCENT_FALL -> -100 * series.meanChange(x) / series.meanAtEndExpiration(x);
            case ORDER -> order(series, observables);
            case RATIO -> Math.abs(series.meanChange(x) / other.meanChange(against));
            case SLOPE -> Math.abs(slope(series, x, against));
            case AT_SHARE -> sizeAtShare(series, x, against, share * other.meanChange(against));
            case CREEP ->
                series.hasHold()
                        ? series.value(x, series.lastRow(0)) - series.value(x, series.endInspirationRow(0))
                        : Double.NaN;
            case HYSTERESIS -> hysteresis(series, x, against);
        };
    }

    private static double order(BreathSeries series, List<String> observables) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 1; i < observables.size(); i++) {
            least = Math.min(
                    least,
                    Math.abs(series.meanChange(observables.get(i - 1)))
                            - Math.abs(series.meanChange(observables.get(i))));
        }
        return least;
    }

    private static double slope(BreathSeries series, String x, String against) {
        int first = series.endExpirationRow(0);
        int deepest = series.endInspirationRow(0);
        double from = series.value(against, first);
        double whole = series.value(against, deepest) - from;
        double n = 0;
        double sy = 0;
        double sx = 0;
        double syy = 0;
        double sxy = 0;
        for (int i = first; i <= deepest; i++) {
            double y = series.value(against, i);
            double share = (y - from) / whole;
            if (share >= SLOPE_FROM && share <= SLOPE_TO) {
                double v = series.value(x, i);
                n++;
                sy += y;
                sx += v;
                syy += y * y;
                sxy += v * y;
            }
        }
        return n < 2 ? Double.NaN : (n * sxy - sx * sy) / (n * syy - sy * sy);
    }

    private static double sizeAtShare(BreathSeries series, String x, String against, double target) {
        int first = series.endExpirationRow(0);
        double y0 = series.value(against, first);
        double x0 = series.value(x, first);
        for (int i = first + 1; i <= series.endInspirationRow(0); i++) {
            double before = (series.value(against, i - 1) - y0) / target;
            double now = (series.value(against, i) - y0) / target;
            if (now >= 1) {
                double t = (1 - before) / (now - before);
                double at = series.value(x, i - 1) + t * (series.value(x, i) - series.value(x, i - 1));
                return Math.abs(at - x0);
            }
        }
        return Double.NaN;
    }

    private static double hysteresis(BreathSeries series, String x, String against) {
        int first = series.endExpirationRow(0);
        int deepest = series.endInspirationRow(0);
        double from = series.value(against, first);
        double to = series.value(against, deepest);
        double most = Double.NaN;
        for (int k = 1; k < HYSTERESIS_LEVELS; k++) {
            double level = from + (to - from) * k / HYSTERESIS_LEVELS;
            double in = crossing(series, x, against, level, first, deepest);
            double out = crossing(series, x, against, level, deepest, series.lastRow(0));
            if (!Double.isNaN(in - out)) {
                most = Double.isNaN(most) ? Math.abs(in - out) : Math.max(most, Math.abs(in - out));
            }
        }
        return most;
    }

    /** Value of x where {@code against} first crosses a level between two rows; NaN if it does not. */
    private static double crossing(BreathSeries series, String x, String against, double level, int from, int to) {
        for (int i = from + 1; i <= to; i++) {
            double before = series.value(against, i - 1) - level;
            double now = series.value(against, i) - level;
            if (before * now <= 0 && before != now) {
                double t = before / (before - now);
                return series.value(x, i - 1) + t * (series.value(x, i) - series.value(x, i - 1));
            }
        }
        return Double.NaN;
    }
}
