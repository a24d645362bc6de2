package org.phrenic.fit.search;

/**
 * One evaluation of the objective.
 *
 * @param point evaluated parameter values, or coordinates in the unit cube
 * @param value objective value; smaller is better
 * @param shape positions of all vertices that the objective compares, as x, y, z triples, mm; empty if the simulation
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
