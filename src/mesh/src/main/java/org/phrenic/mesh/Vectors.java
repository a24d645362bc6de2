package org.phrenic.mesh;

/**
 * Vector arithmetic on arrays of three numbers. Each result is a new array, so these methods do not suit inner loops.
 */
public final class Vectors {
    private Vectors() {}

    public static double[] of(double x, double y, double z) {
        return new double[] {x, y, z};
    }

    /** a + scale b. */
    public static double[] addScaled(double[] a, double[] b, double scale) {
        return of(a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]);
    }

    public static double[] subtract(double[] a, double[] b) {
        return of(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }

    /** Linear interpolation from a at t = 0 to b at t = 1. */
    public static double[] lerp(double[] a, double[] b, double t) {
        return of(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]));
    }

    public static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    public static double[] cross(double[] a, double[] b) {
        return of(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    }

    public static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    /** Squared distance between points a and b of an array with three numbers per point. */
    public static double squaredDistance(double[] p, int a, int b) {
        double dx = p[3 * a] - p[3 * b];
        double dy = p[3 * a + 1] - p[3 * b + 1];
        double dz = p[3 * a + 2] - p[3 * b + 2];
        return dx * dx + dy * dy + dz * dz;
    }

    /** The points at some indices of an array with three numbers per point. */
    public static double[] gather(double[] points, int[] indices) {
        double[] out = new double[3 * indices.length];
        for (int i = 0; i < indices.length; i++) {
            System.arraycopy(points, 3 * indices[i], out, 3 * i, 3);
        }
        return out;
    }

    public static double distance(double[] a, double[] b) {
        return length(subtract(a, b));
    }

    public static double[] normalize(double[] a) {
        double length = length(a);
        return of(a[0] / length, a[1] / length, a[2] / length);
    }

    /** The component of {@code a} orthogonal to the unit vector {@code n}, normalized. */
    public static double[] orthonormalize(double[] a, double[] n) {
        return normalize(addScaled(a, n, -dot(a, n)));
    }

    /** Distance of a point from the line through {@code on} along a unit direction. */
    public static double distanceToLine(double[] point, double[] on, double[] direction) {
        double[] d = subtract(point, on);
        return length(addScaled(d, direction, -dot(d, direction)));
    }

    /** Angle between two directions, degrees. */
    public static double angleDeg(double[] a, double[] b) {
        double cosine = dot(a, b) / (length(a) * length(b));
        return StrictMath.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, cosine))));
    }
}
