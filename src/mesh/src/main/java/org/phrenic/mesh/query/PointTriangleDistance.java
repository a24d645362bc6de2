package org.phrenic.mesh.query;

/**
 * The nearest point of a triangle to a point (Ericson, Real-Time Collision Detection, 2005, section 5.1.5). For
 * degenerate triangles the three sides are searched as well.
 */
final class PointTriangleDistance {
    /** A triangle is degenerate if its squared double area over the fourth power of its longest side is below this. */
    private static final double FLAT = 1e-12;

    private PointTriangleDistance() {}

    /**
     * Whether the triangle at {@code c[o..o+8]} is so thin that its sides must be searched as well.
     *
     * @param n cross product of its sides from the first corner
     */
    static boolean isDegenerate(double[] c, int o, double[] n) {
        double abx = c[o + 3] - c[o];
        double aby = c[o + 4] - c[o + 1];
        double abz = c[o + 5] - c[o + 2];
        double acx = c[o + 6] - c[o];
        double acy = c[o + 7] - c[o + 1];
        double acz = c[o + 8] - c[o + 2];
        double ab = abx * abx + aby * aby + abz * abz;
        double ac = acx * acx + acy * acy + acz * acz;
        double longest = Math.max(ab, ac);
        return !(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] > FLAT * longest * longest);
    }

    /**
     * Squared distance from (x, y, z) to the triangle with corners {@code c[o..o+8]}. The barycentric weights of the
     * second and third corner are written to {@code weights[0..1]}.
     */
    static double squaredDistance(double[] c, int o, double x, double y, double z, double[] weights) {
        double ax = c[o];
        double ay = c[o + 1];
        double az = c[o + 2];
        double abx = c[o + 3] - ax;
        double aby = c[o + 4] - ay;
        double abz = c[o + 5] - az;
        double acx = c[o + 6] - ax;
        double acy = c[o + 7] - ay;
        double acz = c[o + 8] - az;
        double apx = x - ax;
        double apy = y - ay;
        double apz = z - az;
        double d1 = abx * apx + aby * apy + abz * apz;
        double d2 = acx * apx + acy * apy + acz * apz;
        double v;
        double w;
        if (d1 <= 0 && d2 <= 0) {
            v = 0;
            w = 0;
        } else {
            double ab2 = abx * abx + aby * aby + abz * abz;
            double ac2 = acx * acx + acy * acy + acz * acz;
            double abac = abx * acx + aby * acy + abz * acz;
            // d3 to d6 as in the book: the same products for corners b and c.
            double d3 = d1 - ab2;
            double d4 = d2 - abac;
            double d5 = d1 - abac;
            double d6 = d2 - ac2;
            double vc = d1 * d4 - d3 * d2;
            double vb = d5 * d2 - d1 * d6;
            double va = d3 * d6 - d5 * d4;
            if (d3 >= 0 && d4 <= d3) {
                v = 1;
                w = 0;
            } else if (d6 >= 0 && d5 <= d6) {
                v = 0;
                w = 1;
            } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
                v = d1 / (d1 - d3);
                w = 0;
            } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
                v = 0;
                w = d2 / (d2 - d6);
            } else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
                w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
                v = 1 - w;
            } else {
                double scale = 1 / (va + vb + vc);
                v = vb * scale;
                w = vc * scale;
            }
        }
        weights[0] = v;
        weights[1] = w;
        double dx = v * abx + w * acx - apx;
        double dy = v * aby + w * acy - apy;
        double dz = v * abz + w * acz - apz;
        return dx * dx + dy * dy + dz * dz;
    }

    /**
     * {@link #squaredDistance} for a degenerate triangle: the minimum over the three sides and, where valid, the
     * interior.
     */
    static double squaredDistanceToDegenerate(double[] c, int o, double x, double y, double z, double[] weights) {
        double best = squaredDistance(c, o, x, y, z, weights);
        double v = weights[0];
        double w = weights[1];
        if (!(v >= 0 && w >= 0 && v + w <= 1)) {
            best = Double.POSITIVE_INFINITY;
        }
        for (int side = 0; side < 3; side++) {
            int from = o + 3 * side;
            int to = o + (3 * side + 3) % 9;
            double ex = c[to] - c[from];
            double ey = c[to + 1] - c[from + 1];
            double ez = c[to + 2] - c[from + 2];
            double px = x - c[from];
            double py = y - c[from + 1];
            double pz = z - c[from + 2];
            double length = ex * ex + ey * ey + ez * ez;
            double s = length > 0 ? Math.max(0, Math.min(1, (ex * px + ey * py + ez * pz) / length)) : 0;
            double dx = px - s * ex;
            double dy = py - s * ey;
            double dz = pz - s * ez;
            double square = dx * dx + dy * dy + dz * dz;
            if (!(square >= best)) {
                best = square;
                v = side == 0 ? s : side == 1 ? 1 - s : 0;
                w = side == 0 ? 0 : side == 1 ? s : 1 - s;
            }
        }
        weights[0] = v;
        weights[1] = w;
        return best;
    }
}
