package org.phrenic.ui.widget;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Maps values to positions of a slider: linearly; logarithmically, x = min (max / min)^s, where the range spans more
 * than a decade and a half; or, where a range from zero is large against the usual value, logarithmically after a first
 * position at zero.
 *
 * @param minimum value of position 0
 * @param maximum value of position {@link #POSITIONS}
 * @param firstPositive value of position 1 of a logarithmic scale from zero, or of position 0 of one above zero; 0 for
 *     a linear scale
 */
public record SliderScale(double minimum, double maximum, double firstPositive) {
    public static final int POSITIONS = 400;

    private static final double MIN_LOG_RATIO = 31.6;
    private static final double SMALL_FRACTION = 0.06;
    private static final double FIRST_POSITIVE_FRACTION = 0.01;
    /** Ratio of neighbours below which three digits do not distinguish them. */
    private static final double FINE_RATIO = 1.015;

    private static final MathContext DIGITS = new MathContext(3);
    private static final MathContext FINE_DIGITS = new MathContext(4);

    /**
     * The scale for a range.
     *
     * @param usual a value in use, such as the default; NaN if none is known
     */
    public static SliderScale of(double minimum, double maximum, double usual) {
        if (minimum > 0) {
            return new SliderScale(minimum, maximum, maximum / minimum > MIN_LOG_RATIO ? minimum : 0);
        }
        boolean small = usual > 0 && usual < SMALL_FRACTION * maximum;
        return new SliderScale(minimum, maximum, small ? FIRST_POSITIVE_FRACTION * usual : 0);
    }

    boolean isLogarithmic() {
        return firstPositive > 0;
    }

    /** The position nearest to a value; values out of range are at the ends. */
    public int positionOf(double value) {
        if (!isLogarithmic()) {
            return clamp(Math.round(POSITIONS * (value - minimum) / (maximum - minimum)));
        }
        if (value <= minimum) {
            return 0;
        }
        int first = firstLogPosition();
        double share = Math.log(Math.max(value, firstPositive) / firstPositive) / Math.log(maximum / firstPositive);
        return clamp(first + Math.round(share * (POSITIONS - first)));
    }

    /** The value at a position: exact at the ends, a number of few digits between them. */
    public double valueAt(int place) {
        if (place <= 0) {
            return minimum;
        }
        if (place >= POSITIONS) {
            return maximum;
        }
        if (isLogarithmic()) {
            int first = firstLogPosition();
            double share = (place - first) / (double) (POSITIONS - first);
            double ratio = Math.pow(maximum / firstPositive, 1.0 / (POSITIONS - first));
            BigDecimal value = new BigDecimal(firstPositive * Math.pow(maximum / firstPositive, share));
            return value.round(ratio < FINE_RATIO ? FINE_DIGITS : DIGITS).doubleValue();
        }
        double step = (maximum - minimum) / POSITIONS;
        int decimals = (int) -Math.floor(Math.log10(step));
        BigDecimal value = new BigDecimal(minimum + place * step);
        return value.setScale(decimals, RoundingMode.HALF_EVEN).doubleValue();
    }

    private int firstLogPosition() {
        return firstPositive > minimum ? 1 : 0;
    }

    private static int clamp(long place) {
        return (int) Math.max(0, Math.min(POSITIONS, place));
    }
}
