package org.phrenic.anatomy.virtual.shape;

import java.util.function.DoubleUnaryOperator;

/** Roots of functions of one variable. */
public final class RootFinder {
    private static final double TOLERANCE_MM = 1e-5;

    private RootFinder() {}

    /**
     * Finds a root of a function that is negative at 0 and positive far out, searching outward from a guess.
     *
     * @throws IllegalStateException if the function does not become positive within 2 m
     */
    public static double firstOutward(DoubleUnaryOperator f, double guess) {
        double low = guess * 0.96;
        double valueLow = f.applyAsDouble(low);
        while (valueLow > 0 && low > 1e-6) {
            low *= 0.8;
            valueLow = f.applyAsDouble(low);
        }
        double high = Math.max(low * 1.06, 1e-3);
        double valueHigh = f.applyAsDouble(high);
        while (valueHigh <= 0) {
            low = high;
            valueLow = valueHigh;
            high = high * 1.15 + 0.1;
            valueHigh = f.applyAsDouble(high);
            if (high > 2000) {
                throw new IllegalStateException(
                        "a surface of the virtual thorax is open: its measures do not fit together");
            }
        }
        return illinois(f, low, valueLow, high, valueHigh);
    }

    /** Root between a negative and a positive value, by false position (Illinois variant). */
    public static double illinois(DoubleUnaryOperator f, double low, double valueLow, double high, double valueHigh) {
        double a = low;
        double fa = valueLow;
        double b = high;
        double fb = valueHigh;
        int side = 0;
        for (int i = 0; i < 60 && Math.abs(b - a) > TOLERANCE_MM; i++) {
            double c = (fa * b - fb * a) / (fa - fb);
            double fc = f.applyAsDouble(c);
            if (Math.abs(fc) < TOLERANCE_MM) {
                return c;
            }
            if (fc < 0) {
                a = c;
                fa = fc;
                fb = side == -1 ? fb / 2 : fb;
                side = -1;
            } else {
                b = c;
                fb = fc;
                fa = side == 1 ? fa / 2 : fa;
                side = 1;
            }
        }
        return (a + b) / 2;
    }
}
