package org.phrenic.fit.search;

/**
 * One evaluation of the objective. A breath that fails is repeated with less drive ({@link SearchSpace#withDrive}), so
 * the evaluated point may differ from the requested one.
 *
 * @param point evaluated parameter values, or coordinates in the unit cube
 * @param value objective value; smaller is better
 * @param shape positions of all vertices that the objective compares, as x, y, z triples, mm; empty if every attempt
 *     failed or the shape is not kept
 * @param drive drive of the evaluated breath relative to the requested one, at most 1; 0 if every attempt failed
 * @param failure why the requested breath failed; empty if it did not
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Evaluation(double[] point, double value, float[] shape, double drive, String failure) {
    /** Objective value of a failed breath, mm. It is larger than any regular value. */
    public static final double FAILED_MM = 1000;

    /** An evaluation of the requested point. */
    public Evaluation(double[] point, double value, float[] shape) {
        this(point, value, shape, 1, "");
    }

    /** An evaluation without its shape. */
    public Evaluation(double[] point, double value) {
        this(point, value, new float[0]);
    }

    /** A breath that failed. */
    public static Evaluation failed(double[] point, String reason) {
        return new Evaluation(point, FAILED_MM, new float[0], 0, reason);
    }

    /** Whether the requested breath failed, also if one with less drive did not. */
    public boolean hasFailed() {
        return drive < 1;
    }

    boolean hasShape() {
        return shape.length > 0;
    }

    Evaluation withoutShape() {
        return new Evaluation(point, value, new float[0], drive, failure);
    }
}
