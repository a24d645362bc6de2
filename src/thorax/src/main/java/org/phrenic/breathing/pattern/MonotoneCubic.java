package org.phrenic.breathing.pattern;

import java.util.Arrays;

/**
 * A C1 monotone interpolant that stays within the range of the two neighbouring points: piecewise cubic Hermite with
 * the slopes of F. N. Fritsch and J. Butland 1984, doi 10.1137/0905021 (0 at extrema, else the weighted harmonic mean
 * of the neighbouring secants), and slope 0 at both ends. Outside the points it is constant.
 */
final class MonotoneCubic {
    private final double[] x;
    private final double[] y;
    private final double[] slopes;

    /** Interpolates {@code y} at {@code x}, which is strictly increasing; at least two points. */
    MonotoneCubic(double[] x, double[] y) {
        this.x = x;
        this.y = y;
        slopes = new double[x.length];
        for (int i = 1; i < x.length - 1; i++) {
            double before = x[i] - x[i - 1];
            double after = x[i + 1] - x[i];
            double secantBefore = (y[i] - y[i - 1]) / before;
            double secantAfter = (y[i + 1] - y[i]) / after;
            if (secantBefore * secantAfter > 0) {
                double w1 = 2 * after + before;
                double w2 = after + 2 * before;
                slopes[i] = (w1 + w2) / (w1 / secantBefore + w2 / secantAfter);
            }
        }
    }

    double value(double at) {
        if (at <= x[0]) {
            return y[0];
        }
        if (at >= x[x.length - 1]) {
            return y[y.length - 1];
        }
        int i = interval(at);
        double h = x[i + 1] - x[i];
        double u = (at - x[i]) / h;
        double v = 1 - u;
        return v * v * ((1 + 2 * u) * y[i] + u * h * slopes[i])
                + u * u * ((1 + 2 * v) * y[i + 1] - v * h * slopes[i + 1]);
    }

    double slope(double at) {
        if (at <= x[0] || at >= x[x.length - 1]) {
            return 0;
        }
        int i = interval(at);
        double h = x[i + 1] - x[i];
        double u = (at - x[i]) / h;
        return 6 * u * (1 - u) * (y[i + 1] - y[i]) / h
                + (1 - u) * (1 - 3 * u) * slopes[i]
                + u * (3 * u - 2) * slopes[i + 1];
    }

    private int interval(double at) {
        int found = Arrays.binarySearch(x, at);
        return Math.min(found >= 0 ? found : -found - 2, x.length - 2);
    }
}
