package org.phrenic.patient;

/** Moves points. */
interface PointMap {
    /** Moves every point of the array (x, y, z in turn, mm) in place. */
    void apply(double[] points);
}
