package org.phrenic.mesh.query;

/**
 * A disc about each triangle, in its plane and about its centroid, from which follows a lower bound of the distance of
 * a point from the triangle at a third of the cost of the distance itself. With n the normal, c the centre, r the
 * radius, p the point and {@code s = n . (p - c)}, the squared distance from the disc is
 *
 * <pre>
 * s^2 + max(0, sqrt(|p - c|^2 - s^2) - r)^2
 * </pre>
 *
 * Thin triangles, whose normals are inexact, have no bound.
 */
final class TriangleDiscs {
    /** Numbers of a disc: centre, squared radius, unit normal. */
    private static final int SIZE = 7;

    /** Squared double area over the fourth power of the longest side below which a triangle has no bound. */
    private static final double THIN = 1e-4;

    /** Far more than the rounding of the squared radius, relative to it, and of a squared distance, mm^2. */
    private static final double ROUNDING = 1e-8;

    private final double[] discs;

    TriangleDiscs(int triangles) {
        discs = new double[SIZE * triangles];
    }

    /**
     * Sets the disc of a triangle.
     *
     * @param c corners, nine numbers from {@code o}
     * @param normals unit normals of all triangles
     * @param area twice the area of the triangle
     */
    void fit(int place, double[] c, int o, double[] normals, double area) {
        int d = SIZE * place;
        double x = (c[o] + c[o + 3] + c[o + 6]) / 3;
        double y = (c[o + 1] + c[o + 4] + c[o + 7]) / 3;
        double z = (c[o + 2] + c[o + 5] + c[o + 8]) / 3;
        double most = square(c, o, x, y, z);
        double square = square(c, o + 3, x, y, z);
        most = square > most ? square : most;
        square = square(c, o + 6, x, y, z);
        most = square > most ? square : most;
        discs[d] = x;
        discs[d + 1] = y;
        discs[d + 2] = z;
        // No side is longer than twice the radius.
        boolean thin = !(area * area > 16 * THIN * most * most);
        discs[d + 3] = thin ? Double.POSITIVE_INFINITY : most * (1 + ROUNDING);
        discs[d + 4] = normals[3 * place];
        discs[d + 5] = normals[3 * place + 1];
        discs[d + 6] = normals[3 * place + 2];
    }

    private static double square(double[] c, int o, double x, double y, double z) {
        double dx = c[o] - x;
        double dy = c[o + 1] - y;
        double dz = c[o + 2] - z;
        return dx * dx + dy * dy + dz * dz;
    }

    /** Whether a point is certainly farther from a triangle than a squared distance. */
    boolean isFarther(int place, double x, double y, double z, double limit) {
        int d = SIZE * place;
        double squaredRadius = discs[d + 3];
        if (squaredRadius == Double.POSITIVE_INFINITY) {
            return false;
        }
        double dx = x - discs[d];
        double dy = y - discs[d + 1];
        double dz = z - discs[d + 2];
        double height = dx * discs[d + 4] + dy * discs[d + 5] + dz * discs[d + 6];
        double within = limit + ROUNDING * (1 + limit);
        // Squared reach within the plane.
        double reach = within - height * height;
        if (reach < 0) {
            return true;
        }
        double beyond = dx * dx + dy * dy + dz * dz - squaredRadius - within;
        return beyond > 0 && beyond * beyond > 4 * squaredRadius * reach;
    }
}
