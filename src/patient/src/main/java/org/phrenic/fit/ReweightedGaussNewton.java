package org.phrenic.fit;

import org.phrenic.fit.search.BoxConstrainedQuadratic;
import org.phrenic.fit.search.LinearShapeModel;

/**
 * The way down on a linear body: the mean distance of its shape from the targets is made small within a box, by
 * Gauss-Newton steps on squared distances that are weighted by one over the distance, so that their sum is the sum of
 * distances. Nearest points are looked for anew after every step.
 */
final class ReweightedGaussNewton {
    private static final int STEPS = 8;
    private static final int HALVINGS = 3;
    /** Smaller distances count as if they were this large, mm: about what a scan is uneven by. */
    private static final double LEAST_MM = 0.5;
    /** A step shorter than this share of the cube is none. */
    private static final double STILL = 5e-4;

    private final FitObjective body;
    private final LinearShapeModel linear;
    private final int n;
    private final double[][] a;
    private final double[] b;
    private final double[] slope;
    private double mean;

    ReweightedGaussNewton(FitObjective body, LinearShapeModel linear) {
        this.body = body;
        this.linear = linear;
        n = linear.centre().length;
        a = new double[n][n];
        b = new double[n];
        slope = new double[n];
    }

    /**
     * The place with the smallest mean distance that is found.
     *
     * @param reach how far each coordinate may go from where the linear body stands
     * @param damping how much a step is held back, as a share of the mean curvature
     */
    double[] minimize(double reach, double damping) {
        double[] at = linear.centre().clone();
        double[] shape = new double[linear.length()];
        linear.predict(at, shape);
        formNormalEquations(shape);
        for (int step = 0; step < STEPS; step++) {
            double[] low = new double[n];
            double[] high = new double[n];
            double trace = 0;
            for (int k = 0; k < n; k++) {
                low[k] = Math.min(0, Math.max(0, linear.centre()[k] - reach) - at[k]);
                high[k] = Math.max(0, Math.min(1, linear.centre()[k] + reach) - at[k]);
                trace += a[k][k];
            }
            for (int k = 0; k < n; k++) {
                a[k][k] += damping * trace / n + Double.MIN_NORMAL;
            }
            double[] way = BoxConstrainedQuadratic.minimize(a, b, low, high);
            double before = mean;
            double longest = 0;
            double[] next = at.clone();
            double share = 1;
            for (int halving = 0; halving <= HALVINGS; halving++) {
                longest = 0;
                for (int k = 0; k < n; k++) {
                    next[k] = Math.max(0, Math.min(1, at[k] + share * way[k]));
                    longest = Math.max(longest, Math.abs(share * way[k]));
                }
                linear.predict(next, shape);
                formNormalEquations(shape);
                if (mean < before) {
                    break;
                }
                share /= 2;
            }
            if (!(mean < before)) {
                return at;
            }
            at = next;
            if (longest < STILL) {
                return at;
            }
        }
        return at;
    }

    /** Forms the mean distance, its slope and its curvature. */
    private void formNormalEquations(double[] shape) {
        mean = 0;
        java.util.Arrays.fill(b, 0);
        for (double[] row : a) {
            java.util.Arrays.fill(row, 0);
        }
        body.visitDistances(shape, (weight, distance, direction, places, shares) -> {
            mean += weight * distance;
            for (int k = 0; k < n; k++) {
                double[] change = linear.derivative(k);
                double sum = 0;
                for (int c = 0; c < 3; c++) {
                    int p = places[c];
                    if (shares[c] != 0) {
                        sum += shares[c]
                                * (direction[0] * change[p]
                                        + direction[1] * change[p + 1]
                                        + direction[2] * change[p + 2]);
                    }
                }
                slope[k] = sum;
            }
            double counted = weight / Math.max(distance, LEAST_MM);
            for (int k = 0; k < n; k++) {
                b[k] += counted * distance * slope[k];
                double scaled = counted * slope[k];
                for (int j = 0; j < n; j++) {
                    a[k][j] += scaled * slope[j];
                }
            }
        });
    }
}
