package org.phrenic.anatomy.virtual.shape;

/** Smooth blends of implicit functions. */
public final class SmoothBlends {
    private SmoothBlends() {}

    /** 0 for {@code t < 0}, 1 for {@code t > 1}, {@code 3t^2 - 2t^3} between. */
    public static double smoothstep(double t) {
        double u = Math.max(0, Math.min(1, t));
        return u * u * (3 - 2 * u);
    }

    /**
     * Intersection of two regions {@code a < 0} and {@code b < 0} with an edge rounded to this radius (mm). The radius
     * is exact where the surfaces meet at a right angle.
     */
    public static double roundIntersection(double a, double b, double radius) {
        double u = Math.max(a + radius, 0);
        double v = Math.max(b + radius, 0);
        return Math.min(-radius, Math.max(a, b)) + Math.sqrt(u * u + v * v);
    }

    /** Polynomial smooth minimum: union of two regions with a fillet of about {@code k} mm. */
    public static double smoothUnion(double a, double b, double k) {
        double h = Math.max(k - Math.abs(a - b), 0) / k;
        return Math.min(a, b) - h * h * k / 4;
    }
}
