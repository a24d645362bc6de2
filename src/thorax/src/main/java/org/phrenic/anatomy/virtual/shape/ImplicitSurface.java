package org.phrenic.anatomy.virtual.shape;

import org.phrenic.mesh.Vectors;

/**
 * A region given by an implicit function: negative inside, approximately the signed distance in mm near the surface.
 */
@FunctionalInterface
public interface ImplicitSurface {
    double at(double x, double y, double z);

    /** Value at a point. */
    default double at(double[] p) {
        return at(p[0], p[1], p[2]);
    }

    /** Gradient by central differences with a step of 0.05 mm. */
    default double[] gradient(double[] p) {
        double e = 0.05;
        return Vectors.of(
                (at(p[0] + e, p[1], p[2]) - at(p[0] - e, p[1], p[2])) / (2 * e),
                (at(p[0], p[1] + e, p[2]) - at(p[0], p[1] - e, p[2])) / (2 * e),
                (at(p[0], p[1], p[2] + e) - at(p[0], p[1], p[2] - e)) / (2 * e));
    }

    /** Outward unit normal. */
    default double[] normal(double[] p) {
        return Vectors.normalize(gradient(p));
    }

    /** Projects {@code p} on the surface by Newton steps along the gradient, each at most 4 mm long. */
    default double[] project(double[] p, int steps) {
        double[] q = p;
        for (int i = 0; i < steps; i++) {
            double value = at(q[0], q[1], q[2]);
            if (Math.abs(value) < 1e-4) {
                break;
            }
            double e = 0.02;
            double[] g = Vectors.of(
                    (at(q[0] + e, q[1], q[2]) - value) / e,
                    (at(q[0], q[1] + e, q[2]) - value) / e,
                    (at(q[0], q[1], q[2] + e) - value) / e);
            double norm2 = Math.max(Vectors.dot(g, g), 0.05);
            double scale = -value / norm2;
            double most = 4 / Math.sqrt(norm2);
            q = Vectors.addScaled(q, g, Math.max(-most, Math.min(most, scale)));
        }
        return q;
    }
}
