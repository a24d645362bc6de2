package org.phrenic.study.sweep.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.file.Numbers;

/**
 * A linear axis: values to pixels.
 *
 * @param low value at {@code from}
 * @param high value at {@code to}
 * @param from pixel of the least value
 * @param to pixel of the greatest value
 */
record PlotAxis(double low, double high, double from, double to) {
    private static final double MARGIN = 0.04;
    /** Least length of an axis of different values, as a share of them: ticks have 8 digits then, which fit. */
    private static final double LEAST_RANGE = 1e-6;

    private static final int TICKS = 5;
    /** Significant digits of a tick whose step needs no more. */
    private static final int TICK_DIGITS = 4;

    /** An axis that shows all finite values, with a margin. */
    static PlotAxis around(double from, double to, double... values) {
        double[] finite = Arrays.stream(values).filter(Double::isFinite).toArray();
        double low = Arrays.stream(finite).min().orElse(0);
        double high = Arrays.stream(finite).max().orElse(1);
        double range = high - low;
        double least = LEAST_RANGE * Math.max(Math.abs(low), Math.abs(high));
        double room =
                range > 0 ? Math.max(MARGIN * range, (least - range) / 2) : Math.max(1e-9, MARGIN * Math.abs(low));
        return new PlotAxis(low - room, high + room, from, to);
    }

    double at(double value) {
        return from + (value - low) / (high - low) * (to - from);
    }

    double[] at(double[] values) {
        return Arrays.stream(values).map(this::at).toArray();
    }

    /** Between two ticks: 1, 2 or 5 times a power of ten. */
    private double step() {
        double rough = (high - low) / TICKS;
        double power = StrictMath.pow(10, Math.floor(StrictMath.log10(rough)));
        return rough / power <= 1
                ? power
                : rough / power <= 2 ? 2 * power : rough / power <= 5 ? 5 * power : 10 * power;
    }

    /** Round values within the axis: multiples of the step. */
    List<Double> ticks() {
        double step = step();
        List<Double> ticks = new ArrayList<>();
        for (long i = (long) Math.ceil(low / step); i * step <= high; i++) {
            ticks.add(i * step);
        }
        return ticks;
    }

    /** A tick down to the digit of the step. */
    String text(double tick) {
        double digits = 1 + leading(tick) - leading(step());
        return Numbers.trimmed(tick, (int) Math.max(TICK_DIGITS, digits));
    }

    /** Power of ten of the first digit of a number. */
    private static double leading(double value) {
        return Math.floor(StrictMath.log10(Math.abs(value)));
    }
}
