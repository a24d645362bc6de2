package org.phrenic.fit.search;

/**
 * One evaluation of the objective.
 *
 * @param point where: parameter values, or coordinates in the unit cube
 * @param value of the objective, smaller is better
 * @param shape positions of all vertices that the objective compares, x, y, z in turn, mm; empty where the simulation
 *     diverged or the shape is not kept
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Evaluation(double[] point, double value, float[] shape) {
    /** An evaluation without its shape. */
    public Evaluation(double[] point, double value) {
        this(point, value, new float[0]);
    }

    boolean hasShape() {
        return shape.length > 0;
    }
}
