package org.phrenic.anatomy.virtual.shape;

import org.phrenic.mesh.Vectors;

/**
 * An axis for cylindrical coordinates: a point in the horizontal plane at every height z. Azimuth is 0 straight back
 * and positive to the left.
 */
public interface VerticalAxis {
    double x(double z);

    double y(double z);

    /** Point at an azimuth (rad), a distance from the axis (mm) and a height (mm). */
    default double[] point(double azimuth, double radius, double z) {
        return Vectors.of(x(z) + radius * StrictMath.sin(azimuth), y(z) + radius * StrictMath.cos(azimuth), z);
    }
}
