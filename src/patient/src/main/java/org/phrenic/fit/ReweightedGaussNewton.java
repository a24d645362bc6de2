package org.phrenic.fit;

import java.util.Arrays;
import org.phrenic.fit.search.BoxConstrainedQuadratic;
import org.phrenic.fit.search.LinearShapeModel;

/**
 * Minimises the mean distance between a linear shape model and the targets within a box. The method is iteratively
 * reweighted least squares: Gauss-Newton steps on squared distances, each weighted by the inverse distance. Nearest
 * points are recomputed after every step.
 */
final class ReweightedGaussNewton {
    private static final int MAX_STEPS = 8;
    private static final int MAX_HALVINGS = 3;
    /** Lower bound of the distance in a weight, mm. It is about the roughness of a scanned surface. */
    private static final double MIN_DISTANCE_MM = 0.5;
    /** The descent stops when a step is shorter than this, in units of the cube. */
    private static final double MIN_STEP = 5e-4;

    private final FitObjective objective;
    private final LinearShapeModel model;
    private final int n;

    ReweightedGaussNewton(FitObjective objective, LinearShapeModel model) {
        this.objective = objective;
        this.model = model;
        n = model.centre().length;
    }

    /** Mean distance at a point, with its gradient and Gauss-Newton matrix with respect to the parameters. */
    private static final class NormalEquations {
        private final double[][] a;
        private final double[] b;
        private double mean;

        NormalEquations(int n) {
            a = new double[n][n];
            b = new double[n];
        }
    }

    /**
     * Returns the point with the smallest mean distance found.
     *
     * @param radius half width of the box around the centre of the model; the box is clipped to the unit cube
     * @param damping damping of the steps, relative to the mean curvature
     */
    double[] minimize(double radius, double damping) {
        double[] point = model.centre().clone();
        NormalEquations equations = at(point);
        for (int step = 0; step < MAX_STEPS; step++) {
            double[] way = step(equations, point, radius, damping);
            double before = equations.mean;
            double[] next = point.clone();
            double longest = 0;
            double share = 1;
            for (int halving = 0; halving <= MAX_HALVINGS; halving++) {
                longest = 0;
                for (int k = 0; k < n; k++) {
                    next[k] = Math.max(0, Math.min(1, point[k] + share * way[k]));
                    longest = Math.max(longest, Math.abs(share * way[k]));
                }
                equations = at(next);
                if (equations.mean < before) {
                    break;
                }
                share /= 2;
            }
            if (!(equations.mean < before)) {
                return point;
            }
            point = next;
            if (longest < MIN_STEP) {
                return point;
            }
        }
        return point;
    }

    /** Computes the damped step within the box. */
    private double[] step(NormalEquations equations, double[] point, double radius, double damping) {
        double[] low = new double[n];
        double[] high = new double[n];
        double trace = 0;
        for (int k = 0; k < n; k++) {
            low[k] = Math.min(0, Math.max(0, model.centre()[k] - radius) - point[k]);
            high[k] = Math.max(0, Math.min(1, model.centre()[k] + radius) - point[k]);
            trace += equations.a[k][k];
        }
        for (int k = 0; k < n; k++) {
            equations.a[k][k] += damping * trace / n + Double.MIN_NORMAL;
        }
        return BoxConstrainedQuadratic.minimize(equations.a, equations.b, low, high);
    }

    private NormalEquations at(double[] point) {
        double[] shape = new double[model.length()];
        model.predict(point, shape);
        NormalEquations equations = new NormalEquations(n);
        double[] slope = new double[n];
        objective.visitDistances(shape, (weight, distance, direction, places, shares) -> {
            equations.mean += weight * distance;
            Arrays.setAll(slope, k -> slope(model.derivative(k), direction, places, shares));
            double counted = weight / Math.max(distance, MIN_DISTANCE_MM);
            for (int k = 0; k < n; k++) {
                equations.b[k] += counted * distance * slope[k];
                double scaled = counted * slope[k];
                for (int j = 0; j < n; j++) {
                    equations.a[k][j] += scaled * slope[j];
                }
            }
        });
        return equations;
    }

    /** Derivative of a distance with respect to a parameter. */
    private static double slope(double[] change, double[] direction, int[] places, double[] shares) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            int p = places[c];
            if (shares[c] != 0) {
                sum += shares[c]
                        * (direction[0] * change[p] + direction[1] * change[p + 1] + direction[2] * change[p + 2]);
            }
        }
        return sum;
    }
}
