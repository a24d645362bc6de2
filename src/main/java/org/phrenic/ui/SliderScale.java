package org.phrenic.ui;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Where a value stands on a slider. Linear; logarithmic, x = min (max / min)^s, where the range spans more than a decade and a half; from zero on, where a value in use is small against the range, the first place is zero
 * and the others are logarithmic.
 *
 * @param minimum value of place 0
 * @param maximum value of place {@link #PLACES}
 * @param smallest value of place 1 of a logarithmic scale that begins at zero; value of place 0 of one that does not; 0 for a linear scale
 */
record SliderScale(double minimum, double maximum, double smallest) {
    /** Last place of the slider. */
    static final int PLACES = 400;

    private static final double DECADE_AND_A_HALF = 31.6;
    private static final double SMALL_SHARE = 0.06;
    private static final double BELOW_USUAL = 0.01;
    // Three digits tell neighbours apart that differ by more than 1.5 %.
    private static final double COARSE = 1.015;
    private static final MathContext DIGITS = new MathContext(3);
    private static final MathContext FINE_DIGITS = new MathContext(4);

    /**
     * The scale for a range.
     *
     * @param usual a value in use, such as the default; NaN if none is known
     */
    static SliderScale of(double minimum, double maximum, double usual) {
        if (minimum > 0) {
            return new SliderScale(minimum, maximum, maximum / minimum > DECADE_AND_A_HALF ? minimum : 0);
        }
        boolean small = usual > 0 && usual < SMALL_SHARE * maximum;
        return new SliderScale(minimum, maximum, small ? BELOW_USUAL * usual : 0);
    }

    boolean isLogarithmic() {
        return smallest > 0;
    }

    /** The place nearest to a value; values beyond the range are at its ends. */
    int place(double value) {
        if (!isLogarithmic()) {
            return clamp(Math.round(PLACES * (value - minimum) / (maximum - minimum)));
        }
        if (value <= minimum) {
            return 0;
        }
        int first = firstLogarithmic();
        double share = Math.log(Math.max(value, smallest) / smallest) / Math.log(maximum / smallest);
        return clamp(first + Math.round(share * (PLACES - first)));
    }

    /** The value at a place: the ends exactly, between them a number of few digits. */
    double value(int place) {
        if (place <= 0) {
            return minimum;
        }
        if (place >= PLACES) {
            return maximum;
        }
        if (isLogarithmic()) {
            int first = firstLogarithmic();
            double share = (place - first) / (double) (PLACES - first);
            double ratio = Math.pow(maximum / smallest, 1.0 / (PLACES - first));
            return round(smallest * Math.pow(maximum / smallest, share), ratio < COARSE ? FINE_DIGITS : DIGITS);
        }
        double step = (maximum - minimum) / PLACES;
        int decimals = (int) -Math.floor(Math.log10(step));
        return new BigDecimal(minimum + place * step)
                .setScale(decimals, RoundingMode.HALF_EVEN)
                .doubleValue();
    }

    private int firstLogarithmic() {
        return smallest > minimum ? 1 : 0;
    }

    private static double round(double value, MathContext digits) {
        return new BigDecimal(value).round(digits).doubleValue();
    }

    private static int clamp(long place) {
        return (int) Math.max(0, Math.min(PLACES, place));
    }
}
