package org.phrenic.mesh.edit;

/**
 * Normal and shape of a triangle (v, b, c) before and after its corner v moves. The normals are n and m, both (c - b) x
 * (v - b), before and after the move.
 */
final class MovedTriangle {
    /** Dot products n . n, m . m and n . m. */
    double before;

    double after;
    double dot;
    /** Squared longest edge before and after the move, at least the smallest normal number. */
    double longestBefore;

    double longestAfter;

    /**
     * Computes the quantities for one triangle.
     *
     * @param p positions, three numbers per vertex
     */
    void set(double[] p, int v, int b, int c, double x, double y, double z) {
        double bx = p[3 * b];
        double by = p[3 * b + 1];
        double bz = p[3 * b + 2];
        double ex = p[3 * c] - bx;
        double ey = p[3 * c + 1] - by;
        double ez = p[3 * c + 2] - bz;
        double ux = p[3 * v] - bx;
        double uy = p[3 * v + 1] - by;
        double uz = p[3 * v + 2] - bz;
        double wx = x - bx;
        double wy = y - by;
        double wz = z - bz;
        double nx = ey * uz - ez * uy;
        double ny = ez * ux - ex * uz;
        double nz = ex * uy - ey * ux;
        double mx = ey * wz - ez * wy;
        double my = ez * wx - ex * wz;
        double mz = ex * wy - ey * wx;
        before = nx * nx + ny * ny + nz * nz;
        after = mx * mx + my * my + mz * mz;
        dot = nx * mx + ny * my + nz * mz;
        double base = ex * ex + ey * ey + ez * ez;
        longestBefore = longest(base, ux, uy, uz, ux - ex, uy - ey, uz - ez);
        longestAfter = longest(base, wx, wy, wz, wx - ex, wy - ey, wz - ez);
    }

    private static double longest(double base, double ux, double uy, double uz, double dx, double dy, double dz) {
        double first = ux * ux + uy * uy + uz * uz;
        return Math.max(Double.MIN_NORMAL, Math.max(base, Math.max(first, dx * dx + dy * dy + dz * dz)));
    }

    /** Twice the area over the squared longest edge before the move; 0.87 for an equilateral triangle. */
    double shapeBefore() {
        return Math.sqrt(before) / longestBefore;
    }

    /** Twice the area over the squared longest edge after the move. */
    double shapeAfter() {
        return Math.sqrt(after) / longestAfter;
    }
}
