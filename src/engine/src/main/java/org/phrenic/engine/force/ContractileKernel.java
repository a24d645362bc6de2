package org.phrenic.engine.force;

import org.phrenic.engine.parallel.BlockedEdges;

/**
 * Springs without dashpots whose rest length L = l0 - a s decreases with the activation a. Computing L inside the loop
 * is 3 to 7 % faster than updating rest lengths first.
 */
final class ContractileKernel extends SpringKernel {
    private final SpringData data;
    private final double[] shortening;

    ContractileKernel(BlockedEdges edges, SpringData data) {
        super(edges, data);
        this.data = data;
        shortening = data.shortening;
    }

    @Override
    void stars(double[] x, double[] v, double[] force, int from, int to) {
        int[] firsts = own;
        int[] others = other;
        double[] k = stiffness;
        double[] l = rest;
        double[] s = shortening;
        double activation = data.activation;
        for (int i = from; i < to; i += 3) {
            int a = firsts[i];
            double ax = x[a];
            double ay = x[a + 1];
            double az = x[a + 2];

            int b = others[i];
            double dx = x[b] - ax;
            double dy = x[b + 1] - ay;
            double dz = x[b + 2] - az;
            double q = inverseLength(dx, dy, dz);
            double t = k[i] * (1 - (l[i] - activation * s[i]) * q);
            double sx = dx * t;
            double sy = dy * t;
            double sz = dz * t;
            subtract(force, b, sx, sy, sz);

            b = others[i + 1];
            dx = x[b] - ax;
            dy = x[b + 1] - ay;
            dz = x[b + 2] - az;
            q = inverseLength(dx, dy, dz);
            t = k[i + 1] * (1 - (l[i + 1] - activation * s[i + 1]) * q);
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
            t = k[i + 2] * (1 - (l[i + 2] - activation * s[i + 2]) * q);
            fx = dx * t;
            fy = dy * t;
            fz = dz * t;
            subtract(force, b, fx, fy, fz);
            add(force, a, sx + fx, sy + fy, sz + fz);
        }
    }

    @Override
    void singles(double[] x, double[] v, double[] force, int from, int to, boolean bothEnds) {
        double activation = data.activation;
        for (int i = from; i < to; i++) {
            int a = own[i];
            int b = other[i];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double q = inverseLength(dx, dy, dz);
            double t = stiffness[i] * (1 - (rest[i] - activation * shortening[i]) * q);
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
