package org.phrenic.mesh.query;

/** Solid angles of triangles (Van Oosterom and Strackee 1983, doi 10.1109/TBME.1983.325207). */
final class SolidAngles {
    private SolidAngles() {}

    /**
     * Half the sum of the triangles' signed solid angles seen from a point. {@code corners} has nine numbers per
     * triangle.
     */
    static double sum(double[] corners, double x, double y, double z) {
        double sum = 0;
        for (int o = 0; o < corners.length; o += 9) {
            double ax = corners[o] - x;
            double ay = corners[o + 1] - y;
            double az = corners[o + 2] - z;
            double bx = corners[o + 3] - x;
            double by = corners[o + 4] - y;
            double bz = corners[o + 5] - z;
            double cx = corners[o + 6] - x;
            double cy = corners[o + 7] - y;
            double cz = corners[o + 8] - z;
            double a = Math.sqrt(ax * ax + ay * ay + az * az);
            double b = Math.sqrt(bx * bx + by * by + bz * bz);
            double c = Math.sqrt(cx * cx + cy * cy + cz * cz);
            double determinant = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
            double divisor = a * b * c
                    + (ax * bx + ay * by + az * bz) * c
                    + (bx * cx + by * cy + bz * cz) * a
                    + (cx * ax + cy * ay + cz * az) * b;
            sum += StrictMath.atan2(determinant, divisor);
        }
        return sum;
    }
}
