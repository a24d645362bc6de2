package org.phrenic.fit.search;

/** Minimises the convex quadratic {@code 1/2 s' A s + b' s} within a box by coordinate descent. */
public final class BoxConstrainedQuadratic {
    private static final int MAX_SWEEPS = 500;
    private static final double TOLERANCE = 1e-10;

    private BoxConstrainedQuadratic() {}

    /**
     * Returns the minimiser.
     *
     * @param a symmetric, positive definite matrix A
     * @param low lower bounds, at most 0
     * @param high upper bounds, at least 0
     */
    public static double[] minimize(double[][] a, double[] b, double[] low, double[] high) {
        double[] s = new double[b.length];
        double moved = Double.POSITIVE_INFINITY;
        for (int sweep = 0; sweep < MAX_SWEEPS && moved >= TOLERANCE; sweep++) {
            moved = 0;
            for (int i = 0; i < s.length; i++) {
                double gradient = b[i];
                for (int j = 0; j < s.length; j++) {
                    gradient += a[i][j] * s[j];
                }
                double to = Math.max(low[i], Math.min(high[i], s[i] - gradient / a[i][i]));
                moved = Math.max(moved, Math.abs(to - s[i]));
                s[i] = to;
            }
        }
        return s;
    }
}
