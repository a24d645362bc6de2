package org.phrenic.engine.math;

/**
 * Arithmetic of one triangle among many, whose corners lie in an array of three numbers a vertex. Allocates nothing.
 */
public final class Triangles {
    private Triangles() {}

    /**
     * The cross product of two sides, (b - a) x (c - a): it stands on the triangle, on the side from which the corners
     * go anticlockwise.
     *
     * @param p positions, three numbers a vertex
     * @param a where the first corner begins in {@code p}, three times its number; so {@code b} and {@code c}
     * @param out receives the product, three numbers
     * @return its length, twice the triangle's area
     */
    public static double cross(double[] p, int a, int b, int c, double[] out) {
        double ux = p[b] - p[a];
        double uy = p[b + 1] - p[a + 1];
        double uz = p[b + 2] - p[a + 2];
        double vx = p[c] - p[a];
        double vy = p[c + 1] - p[a + 1];
        double vz = p[c + 2] - p[a + 2];
        out[0] = uy * vz - uz * vy;
        out[1] = uz * vx - ux * vz;
        out[2] = ux * vy - uy * vx;
        return Math.sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    }

    /**
     * The unit normal, on the side from which the corners go anticlockwise; zero for a triangle without area.
     * Parameters as for {@link #cross}.
     *
     * @return twice the triangle's area
     */
    public static double normal(double[] p, int a, int b, int c, double[] out) {
        double length = cross(p, a, b, c, out);
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = length > 0 ? out[axis] / length : 0;
        }
        return length;
    }
}
