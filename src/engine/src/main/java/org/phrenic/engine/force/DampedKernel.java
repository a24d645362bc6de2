package org.phrenic.engine.force;

import org.phrenic.engine.parallel.BlockedEdges;

/** Springs with a dashpot along each edge. */
final class DampedKernel extends SpringKernel {
    /** Damping coefficient, N s/m. */
    private final double damping;

    DampedKernel(BlockedEdges edges, SpringData data) {
        super(edges, data);
        damping = data.damping;
    }

    @Override
    void stars(double[] x, double[] v, double[] force, int from, int to) {
        int[] firsts = own;
        int[] others = other;
        double[] k = stiffness;
        double[] l = rest;
        double c = damping;
        for (int i = from; i < to; i += 3) {
            int a = firsts[i];
            double ax = x[a];
            double ay = x[a + 1];
            double az = x[a + 2];
            double ux = v[a];
            double uy = v[a + 1];
            double uz = v[a + 2];

            int b = others[i];
            double dx = x[b] - ax;
            double dy = x[b + 1] - ay;
            double dz = x[b + 2] - az;
            double q = inverseLength(dx, dy, dz);
            double along = (v[b] - ux) * dx + (v[b + 1] - uy) * dy + (v[b + 2] - uz) * dz;
            double t = k[i] * (1 - l[i] * q) + c * (along * (q * q));
            double sx = dx * t;
            double sy = dy * t;
            double sz = dz * t;
            subtract(force, b, sx, sy, sz);

            b = others[i + 1];
            dx = x[b] - ax;
            dy = x[b + 1] - ay;
            dz = x[b + 2] - az;
            q = inverseLength(dx, dy, dz);
            along = (v[b] - ux) * dx + (v[b + 1] - uy) * dy + (v[b + 2] - uz) * dz;
            t = k[i + 1] * (1 - l[i + 1] * q) + c * (along * (q * q));
            double fx = dx * t;
            double fy = dy * t;
            double fz = dz * t;
            subtract(force, b, fx, fy, fz);
            sx += fx;
            sy += fy;
            sz += fz;

            b = others[i + 2];
            dx = x[b] - ax;
            dy = x[b + 1] - ay;
            dz = x[b + 2] - az;
            q = inverseLength(dx, dy, dz);
            along = (v[b] - ux) * dx + (v[b + 1] - uy) * dy + (v[b + 2] - uz) * dz;
            t = k[i + 2] * (1 - l[i + 2] * q) + c * (along * (q * q));
            fx = dx * t;
            fy = dy * t;
            fz = dz * t;
            subtract(force, b, fx, fy, fz);
            add(force, a, sx + fx, sy + fy, sz + fz);
        }
    }

    @Override
    void singles(double[] x, double[] v, double[] force, int from, int to, boolean bothEnds) {
        for (int i = from; i < to; i++) {
            int a = own[i];
            int b = other[i];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double q = inverseLength(dx, dy, dz);
            double along = (v[b] - v[a]) * dx + (v[b + 1] - v[a + 1]) * dy + (v[b + 2] - v[a + 2]) * dz;
            double t = stiffness[i] * (1 - rest[i] * q) + damping * (along * (q * q));
            double fx = dx * t;
            double fy = dy * t;
            double fz = dz * t;
            add(force, a, fx, fy, fz);
            if (bothEnds) {
                subtract(force, b, fx, fy, fz);
            }
        }
    }
}
