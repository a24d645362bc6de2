package org.phrenic.engine.force;

/** A smooth fall-off with distance: (1 - (d/r)²)² inside the radius, 0 outside. It is C¹ everywhere. */
public final class FallOff {
    private FallOff() {}

    /**
     * @param distance from the centre or line, mm
     * @param radius radius of the fall-off, mm, more than 0
     * @return 1 at the centre, 0 at the radius and beyond
     */
    public static double at(double distance, double radius) {
        double q = distance / radius;
        if (q >= 1) {
            return 0;
        }
        double s = 1 - q * q;
        return s * s;
    }
}
