package org.phrenic.fit.search;

/**
 * Linear model of the shape near a point of the unit cube. It consists of the shape at that point and its derivative
 * with respect to each parameter. The derivatives come from finite differences and are updated by Broyden's rank-one
 * formula (1965, doi 10.1090/S0025-5718-1965-0198670-6), with one row per vertex coordinate.
 */
public final class LinearShapeModel {
    /**
     * Points closer to the centre than this do not update the derivatives because their differences are mostly noise.
     */
    private static final double MIN_UPDATE_DISTANCE = 0.01;

    private final double[][] derivative;
    private double[] centre;
    private double[] shape;

    LinearShapeModel(int dimension) {
        derivative = new double[dimension][];
    }

    /** Point around which the model is linearised. */
    public double[] centre() {
        return centre;
    }

    /** Derivative of the shape with respect to a parameter, mm per unit of the cube. */
    public double[] derivative(int parameter) {
        return derivative[parameter];
    }

    /** Number of coordinates of a shape. */
    public int length() {
        return shape.length;
    }

    /** Moves the centre to a point of known shape. The derivatives are unchanged. */
    void recentre(double[] point, float[] known) {
        centre = point.clone();
        shape = new double[known.length];
        for (int i = 0; i < shape.length; i++) {
            shape[i] = known[i];
        }
        for (int k = 0; k < derivative.length; k++) {
            if (derivative[k] == null) {
                derivative[k] = new double[shape.length];
            }
        }
    }

    /** Sets one derivative from the shape at a point that differs from the centre in this parameter only. */
    void setFiniteDifference(int parameter, double step, float[] other) {
        for (int i = 0; i < shape.length; i++) {
            derivative[parameter][i] = (other[i] - shape[i]) / step;
        }
    }

    /** Computes the predicted shape at a point. */
    public void predict(double[] point, double[] out) {
        System.arraycopy(shape, 0, out, 0, shape.length);
        for (int k = 0; k < point.length; k++) {
            addScaled(point[k] - centre[k], derivative[k], out);
        }
    }

    /** Applies the smallest change of the derivatives that makes the model exact at another point. */
    void broydenUpdate(double[] point, float[] other) {
        double squared = 0;
        for (int k = 0; k < point.length; k++) {
            squared += (point[k] - centre[k]) * (point[k] - centre[k]);
        }
        if (squared < MIN_UPDATE_DISTANCE * MIN_UPDATE_DISTANCE) {
            return;
        }
        double[] residual = new double[shape.length];
        predict(point, residual);
        for (int i = 0; i < residual.length; i++) {
            residual[i] = other[i] - residual[i];
        }
        for (int k = 0; k < point.length; k++) {
            addScaled((point[k] - centre[k]) / squared, residual, derivative[k]);
        }
    }

    private static void addScaled(double scale, double[] x, double[] y) {
        for (int i = 0; i < y.length && scale != 0; i++) {
            y[i] += scale * x[i];
        }
    }
}
