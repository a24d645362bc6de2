package org.phrenic.motion;

/** Displacement of the points of one region of a body, mm. It is defined everywhere, also beyond its region. */
@FunctionalInterface
interface RegionField {
    /** Writes the displacement of the point (x, y, z). */
    void at(double x, double y, double z, double[] out);
}
