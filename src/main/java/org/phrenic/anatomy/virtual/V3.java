package org.phrenic.anatomy.virtual;

/** Vectors as {@code double[3]} and the few blends that shapes here are made of. */
final class V3 {
    private V3() {}

    static double[] of(double x, double y, double z) {
        return new double[] {x, y, z};
    }

    static double[] add(double[] a, double[] b, double scale) {
        return of(a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]);
    }

    static double[] minus(double[] a, double[] b) {
        return of(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }

    static double[] lerp(double[] a, double[] b, double t) {
        return of(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]));
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] cross(double[] a, double[] b) {
        return of(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    }

    static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    static double distance(double[] a, double[] b) {
        return length(minus(a, b));
    }

    static double[] unit(double[] a) {
        double length = length(a);
        return of(a[0] / length, a[1] / length, a[2] / length);
    }

    /** {@code a} without its part along the unit vector {@code n}, made a unit vector. */
    static double[] unitAcross(double[] a, double[] n) {
        return unit(add(a, n, -dot(a, n)));
    }

    /** 0 below 0, 1 above 1, {@code 3t^2 - 2t^3} between. */
    static double smoothstep(double t) {
        double u = Math.max(0, Math.min(1, t));
        return u * u * (3 - 2 * u);
    }

    /**
     * Intersection of two regions {@code a < 0} and {@code b < 0} whose edge is rounded with this radius (distances in mm, exact
     * where the two surfaces meet at a right angle).
     */
    static double roundMax(double a, double b, double radius) {
        double u = Math.max(a + radius, 0);
        double v = Math.max(b + radius, 0);
        return Math.min(-radius, Math.max(a, b)) + Math.sqrt(u * u + v * v);
    }

    /** Polynomial smooth minimum: union of two regions with a fillet of about {@code k} mm. */
    static double smoothMin(double a, double b, double k) {
        double h = Math.max(k - Math.abs(a - b), 0) / k;
        return Math.min(a, b) - h * h * k / 4;
    }
}
