package org.phrenic.anatomy.virtual.shape;

import java.util.Arrays;

/**
 * Monotone interpolation of a table: piecewise cubic Hermite with the slopes of Fritsch and Butland 1984 (doi
 * 10.1137/0905021), without overshoot. Beyond its ends the curve continues linearly with the end slope.
 */
public final class ProfileCurve {
    private final double[] at;
    private final double[] value;
    private final double[] slope;

    /**
     * @param at abscissae, strictly increasing, at least two
     * @param value ordinates, as many as abscissae
     */
    public ProfileCurve(double[] at, double[] value) {
        this.at = at.clone();
        this.value = value.clone();
        int n = at.length;
        slope = new double[n];
        double[] secant = new double[n - 1];
        for (int i = 0; i < n - 1; i++) {
            secant[i] = (value[i + 1] - value[i]) / (at[i + 1] - at[i]);
        }
        slope[0] = secant[0];
        slope[n - 1] = secant[n - 2];
        for (int i = 1; i < n - 1; i++) {
            double before = at[i] - at[i - 1];
            double after = at[i + 1] - at[i];
            if (secant[i - 1] * secant[i] > 0) {
                double w1 = 2 * after + before;
                double w2 = after + 2 * before;
                slope[i] = (w1 + w2) / (w1 / secant[i - 1] + w2 / secant[i]);
            }
        }
    }

    /** Value at {@code t}. */
    public double at(double t) {
        int n = at.length;
        if (t <= at[0]) {
            return value[0] + slope[0] * (t - at[0]);
        }
        if (t >= at[n - 1]) {
            return value[n - 1] + slope[n - 1] * (t - at[n - 1]);
        }
        int found = Arrays.binarySearch(at, t);
        int low = found >= 0 ? found : -found - 2;
        int high = low + 1;
        double h = at[high] - at[low];
        double u = (t - at[low]) / h;
        double v = 1 - u;
        return value[low] * v * v * (1 + 2 * u)
                + value[high] * u * u * (1 + 2 * v)
                + h * u * v * (slope[low] * v - slope[high] * u);
    }
}
