package org.phrenic.fit.search;

/**
 * What came of an evaluation.
 *
 * @param value what it is worth, smaller is better
 * @param shape places of all vertices that a fit looks at, x, y, z in turn, mm; without any where the body came apart
 *     or there is no body
 */
@SuppressWarnings("ArrayRecordComponent")
public // never compared
record Evaluation(double value, float[] shape) {
    boolean hasShape() {
        return shape.length > 0;
    }
}
