package org.phrenic.fit.search;

/** The smallest value of a convex quadratic in a box: {@code 1/2 s' A s + b' s}, by coordinate descent. */
public final class BoxConstrainedQuadratic {
    private static final int MOST_SWEEPS = 500;
    private static final double STILL = 1e-10;

    private BoxConstrainedQuadratic() {}

    /**
     * Where it is smallest.
     *
     * @param a symmetric, positive definite
     * @param low least of each coordinate, not above 0
     * @param high greatest of each, not below 0
     */
    public static double[] minimize(double[][] a, double[] b, double[] low, double[] high) {
        int n = b.length;
        double[] s = new double[n];
        for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
            double moved = 0;
            for (int i = 0; i < n; i++) {
                double gradient = b[i];
                for (int j = 0; j < n; j++) {
                    gradient += a[i][j] * s[j];
                }
                double to = Math.max(low[i], Math.min(high[i], s[i] - gradient / a[i][i]));
                moved = Math.max(moved, Math.abs(to - s[i]));
                s[i] = to;
            }
            if (moved < STILL) {
                break;
            }
        }
        return s;
    }
}
