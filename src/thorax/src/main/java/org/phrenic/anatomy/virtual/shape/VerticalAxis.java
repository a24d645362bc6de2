package org.phrenic.anatomy.virtual.shape;

import org.phrenic.mesh.Vectors;

/**
 * An upright line through a part, about which its surfaces are described: at every height z a point in the horizontal
 * plane, and about it an azimuth, 0 straight back and positive to the left.
 */
public interface VerticalAxis {
    double x(double z);

    double y(double z);

    /** The point at this azimuth (rad), distance from the axis and height. */
    default double[] point(double azimuth, double radius, double z) {
        return Vectors.of(x(z) + radius * StrictMath.sin(azimuth), y(z) + radius * StrictMath.cos(azimuth), z);
    }
}
