package org.phrenic.engine.math;

/** Geometry of triangles whose corners are stored in an array of three coordinates a vertex. Allocates nothing. */
public final class Triangles {
    private Triangles() {}

    /**
     * The cross product of two sides, (b - a) x (c - a). It points to the side from which the corners are
     * anticlockwise.
     *
     * @param p positions, three coordinates a vertex
     * @param a index of the first corner in {@code p}, three times its vertex number; {@code b} and {@code c} likewise
     * @param out receives the product, three components
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
     * The unit normal on the side from which the corners are anticlockwise; zero for a degenerate triangle. Parameters
     * as for {@link #cross}.
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
