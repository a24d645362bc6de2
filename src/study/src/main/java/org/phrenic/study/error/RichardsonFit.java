package org.phrenic.study.error;

import java.util.Arrays;

/**
 * Richardson extrapolation: the limit of a quantity that depends on the mesh as {@code q(h) = limit + c h^order}, by
 * least squares over at least three edge lengths h. For a given order, limit and c follow from a linear regression; the
 * order is found by a golden-section search for the least sum of squared residuals between {@value #MIN_ORDER} and
 * {@value #MAX_ORDER} (Roache 1994, doi 10.1115/1.2910291).
 *
 * <p>A quantity may also scatter from mesh to mesh, as a sheet that folds does. An order is observed if the fitted
 * quantity on the coarsest mesh differs from the limit by more than three times the scatter.
 *
 * @param limit extrapolated to edge length 0
 * @param order observed order of convergence; one of the bounds if the quantity does not converge as a power
 * @param scatter standard deviation of the quantity about the fit, in its unit: the root of the sum of squared
 *     residuals over the number of meshes less the three parameters of the fit; NaN with three meshes
 * @param change of the fitted quantity from the limit to the coarsest mesh
 */
public record RichardsonFit(double limit, double order, double scatter, double change) {
    /** Lower bound of the order. */
    public static final double MIN_ORDER = 0.3;
    /** Upper bound of the order. */
    public static final double MAX_ORDER = 4;
    /** Least number of meshes: the number of parameters of the fit. */
    static final int LEAST_MESHES = 3;

    private static final double GOLDEN = 0.5 * (Math.sqrt(5) - 1);
    private static final int ITERATIONS = 60;
    /** An order nearer to a bound is the bound. */
    private static final double MARGIN = 0.01;

    /**
     * Fits a quantity.
     *
     * @param edges edge lengths, positive and decreasing
     * @param values the quantity on each mesh
     * @throws IllegalArgumentException with fewer than three meshes, unequal numbers of edge lengths and values, or
     *     edge lengths that do not decrease
     */
    public static RichardsonFit of(double[] edges, double[] values) {
        if (edges.length < LEAST_MESHES || values.length != edges.length) {
            throw new IllegalArgumentException("found " + edges.length + " edge lengths and " + values.length
                    + " values, expected as many values as edge lengths, at least three");
        }
        for (int i = 0; i < edges.length; i++) {
            if (!(edges[i] > 0 && (i == 0 || edges[i] < edges[i - 1]))) {
                throw new IllegalArgumentException(
                        "edge lengths: found " + Arrays.toString(edges) + ", expected positive ones that decrease");
            }
        }
        double low = MIN_ORDER;
        double high = MAX_ORDER;
        for (int i = 0; i < ITERATIONS; i++) {
            double a = high - GOLDEN * (high - low);
            double b = low + GOLDEN * (high - low);
            if (line(edges, values, a)[2] < line(edges, values, b)[2]) {
                high = b;
            } else {
                low = a;
            }
        }
        double order = 0.5 * (low + high);
        double[] line = line(edges, values, order);
        int free = edges.length - LEAST_MESHES;
        double scatter = free > 0 ? Math.sqrt(line[2] / free) : Double.NaN;
        return new RichardsonFit(line[0], order, scatter, line[1]);
    }

    /**
     * Whether an order of convergence is observed: the quantity converges as a power between the bounds, by more than
     * its scatter.
     */
    public boolean hasOrder() {
        boolean resolved = Double.isNaN(scatter) || Math.abs(change) > ErrorStudy.RESOLVED * scatter;
        return resolved && order > MIN_ORDER + MARGIN && order < MAX_ORDER - MARGIN;
    }

    /** Limit, slope and sum of squares of the regression of the values over {@code h^order}. */
    private static double[] line(double[] edges, double[] values, double order) {
        int n = edges.length;
        double meanX = 0;
        double meanY = 0;
        for (int i = 0; i < n; i++) {
            meanX += StrictMath.pow(edges[i] / edges[0], order) / n;
            meanY += values[i] / n;
        }
        double xx = 0;
        double xy = 0;
        for (int i = 0; i < n; i++) {
            double x = StrictMath.pow(edges[i] / edges[0], order) - meanX;
            xx += x * x;
            xy += x * (values[i] - meanY);
        }
        double slope = xy / xx;
        double squares = 0;
        for (int i = 0; i < n; i++) {
            double x = StrictMath.pow(edges[i] / edges[0], order) - meanX;
            squares += (values[i] - meanY - slope * x) * (values[i] - meanY - slope * x);
        }
        return new double[] {meanY - slope * meanX, slope, squares};
    }
}
