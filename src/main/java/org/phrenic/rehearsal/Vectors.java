package org.phrenic.rehearsal;

/** Arithmetic of points and directions, three numbers each. */
final class Vectors {
    private Vectors() {}

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    /** a + s b. */
    static double[] along(double[] a, double s, double[] b) {
        return new double[] {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
    }

    static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    static double distance(double[] a, double[] b) {
        return length(minus(a, b));
    }

    static double[] unit(double[] a) {
        double length = length(a);
        return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }

    /** Distance of a point from a line through {@code on} along a unit direction. */
    static double toLine(double[] point, double[] on, double[] direction) {
        double[] d = minus(point, on);
        return length(along(d, -dot(d, direction), direction));
    }

    /** Angle between two directions, degrees. */
    static double angleDeg(double[] a, double[] b) {
        double cosine = dot(a, b) / (length(a) * length(b));
        return StrictMath.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, cosine))));
    }
}
