package org.phrenic.patient.registration;

/** Moves points. */
interface PointTransform {
    /** Moves every point of the array (x, y, z in turn, mm) in place. */
    void apply(double[] points);
}
