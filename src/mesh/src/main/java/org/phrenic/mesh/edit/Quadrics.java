package org.phrenic.mesh.edit;

/**
 * Quadric error metrics per vertex (Garland and Heckbert 1997, Surface Simplification Using Quadric Error Metrics, doi
 * 10.1145/258734.258849). A quadric is an area-weighted sum of squared distances to planes, x A x + 2 b x + c, stored
 * as ten numbers. Positions are relative to a common origin inside the body, which preserves precision.
 */
final class Quadrics {
    private static final int WIDTH = 10;
    /**
     * Regularization towards the edge midpoint, relative to the trace, for directions that the planes do not determine.
     */
    private static final double PULL = 1e-3;

    private final double[] q;
    private final double[] origin;
    /** Coordinates of the point found by the last {@link #minimize}. */
    double x;

    double y;
    double z;

    Quadrics(int vertices, double[] origin) {
        q = new double[WIDTH * vertices];
        this.origin = origin.clone();
    }

    /** Adds to vertex {@code v} the plane through a point of an array with the given unit normal. */
    void add(int v, double nx, double ny, double nz, double[] points, int point, double weight) {
        double d = -(nx * (points[3 * point] - origin[0])
                + ny * (points[3 * point + 1] - origin[1])
                + nz * (points[3 * point + 2] - origin[2]));
        int o = WIDTH * v;
        q[o] += weight * nx * nx;
        q[o + 1] += weight * nx * ny;
        q[o + 2] += weight * nx * nz;
        q[o + 3] += weight * ny * ny;
        q[o + 4] += weight * ny * nz;
        q[o + 5] += weight * nz * nz;
        q[o + 6] += weight * nx * d;
        q[o + 7] += weight * ny * d;
        q[o + 8] += weight * nz * d;
        q[o + 9] += weight * d * d;
    }

    /** Adds the quadric of {@code from} to vertex {@code to}. */
    void merge(int from, int to) {
        for (int k = 0; k < WIDTH; k++) {
            q[WIDTH * to + k] += q[WIDTH * from + k];
        }
    }

    /** Minimizes the summed quadric of two vertices, starting from (mx, my, mz); returns the minimum. */
    double minimize(int a, int b, double mx, double my, double mz) {
        int i = WIDTH * a;
        int j = WIDTH * b;
        double m0 = mx - origin[0];
        double m1 = my - origin[1];
        double m2 = mz - origin[2];
        double axx = q[i] + q[j];
        double axy = q[i + 1] + q[j + 1];
        double axz = q[i + 2] + q[j + 2];
        double ayy = q[i + 3] + q[j + 3];
        double ayz = q[i + 4] + q[j + 4];
        double azz = q[i + 5] + q[j + 5];
        // Half the gradient at m.
        double gx = axx * m0 + axy * m1 + axz * m2 + q[i + 6] + q[j + 6];
        double gy = axy * m0 + ayy * m1 + ayz * m2 + q[i + 7] + q[j + 7];
        double gz = axz * m0 + ayz * m1 + azz * m2 + q[i + 8] + q[j + 8];
        double pull = PULL * (axx + ayy + azz);
        double bxx = axx + pull;
        double byy = ayy + pull;
        double bzz = azz + pull;
        double cxx = byy * bzz - ayz * ayz;
        double cxy = axz * ayz - axy * bzz;
        double cxz = axy * ayz - axz * byy;
        double determinant = bxx * cxx + axy * cxy + axz * cxz;
        if (!(determinant > 0)) {
            x = mx;
            y = my;
            z = mz;
        } else {
            double cyy = bxx * bzz - axz * axz;
            double cyz = axy * axz - bxx * ayz;
            double czz = bxx * byy - axy * axy;
            x = mx - (cxx * gx + cxy * gy + cxz * gz) / determinant;
            y = my - (cxy * gx + cyy * gy + cyz * gz) / determinant;
            z = mz - (cxz * gx + cyz * gy + czz * gz) / determinant;
        }
        return Math.max(0, evaluate(i, x, y, z) + evaluate(j, x, y, z));
    }

    private double evaluate(int o, double px, double py, double pz) {
        double dx = px - origin[0];
        double dy = py - origin[1];
        double dz = pz - origin[2];
        return dx * (q[o] * dx + 2 * (q[o + 1] * dy + q[o + 2] * dz + q[o + 6]))
                + dy * (q[o + 3] * dy + 2 * (q[o + 4] * dz + q[o + 7]))
                + dz * (q[o + 5] * dz + 2 * q[o + 8])
                + q[o + 9];
    }
}
