package org.phrenic.engine.force;

import org.phrenic.engine.parallel.BlockedEdges;

/**
 * Forces of springs. With d = x(a) - x(b), u = v(a) - v(b) and the rest length L at the current activation:
 *
 * <pre>
 * q = 1 / |d|,   t = k (1 - L q) + c (u·d) (q q),   f = -t d on a, t d on b
 * </pre>
 *
 * <p>Operations are rounded one by one in this order. The entries of a block are passed over three times: d·d and u·d
 * are gathered, t is computed, and t d is scattered. The pass over t reads and writes arrays in sequence, so that the
 * compiler vectorises its roots and quotients, which have a latency of tens of cycles. The difference d is computed
 * twice, since that takes less time than to store it.
 */
final class SpringKernel {
    /** First and second node of each entry times 3. */
    private final int[] own;

    private final int[] other;
    private final SpringData data;
    /** d·d of each entry after the first pass, mm2; t after the second, N/m. */
    private final double[] tension;
    /** u·d of each entry, mm2/s; empty without dashpots. */
    private final double[] along;

    SpringKernel(BlockedEdges edges, SpringData data) {
        own = edges.own;
        other = edges.other;
        this.data = data;
        tension = new double[own.length];
        along = new double[data.damping == 0 ? 0 : own.length];
    }

    /** Adds forces on both ends for the entries {@code [from, to)}, in groups of three with the same first node. */
    void stars(double[] x, double[] v, double[] force, int from, int to) {
        if (data.damping == 0) {
            gatherStars(x, from, to);
        } else {
            gatherDampedStars(x, v, from, to);
        }
        computeTension(from, to);
        scatterStars(x, force, from, to);
    }

    /** Adds forces for any entries, on the first node, and on the second node if {@code bothEnds}. */
    void singles(double[] x, double[] v, double[] force, int from, int to, boolean bothEnds) {
        if (data.damping == 0) {
            gatherSingles(x, from, to);
        } else {
            gatherDampedSingles(x, v, from, to);
        }
        computeTension(from, to);
        scatterSingles(x, force, from, to, bothEnds);
    }

    private void gatherStars(double[] x, int from, int to) {
        int[] firsts = own;
        int[] others = other;
        double[] squared = tension;
        for (int i = from; i < to; i += 3) {
            int a = firsts[i];
            double ax = x[a];
            double ay = x[a + 1];
            double az = x[a + 2];
            int b = others[i];
            squared[i] = squaredLength(ax - x[b], ay - x[b + 1], az - x[b + 2]);
            b = others[i + 1];
            squared[i + 1] = squaredLength(ax - x[b], ay - x[b + 1], az - x[b + 2]);
            b = others[i + 2];
            squared[i + 2] = squaredLength(ax - x[b], ay - x[b + 1], az - x[b + 2]);
        }
    }

    private void gatherDampedStars(double[] x, double[] v, int from, int to) {
        int[] firsts = own;
        int[] others = other;
        double[] squared = tension;
        double[] rate = along;
        for (int i = from; i < to; i += 3) {
            int a = firsts[i];
            double ax = x[a];
            double ay = x[a + 1];
            double az = x[a + 2];
            double ux = v[a];
            double uy = v[a + 1];
            double uz = v[a + 2];

            int b = others[i];
            double dx = ax - x[b];
            double dy = ay - x[b + 1];
            double dz = az - x[b + 2];
            rate[i] = (ux - v[b]) * dx + (uy - v[b + 1]) * dy + (uz - v[b + 2]) * dz;
            squared[i] = squaredLength(dx, dy, dz);

            b = others[i + 1];
            dx = ax - x[b];
            dy = ay - x[b + 1];
            dz = az - x[b + 2];
            rate[i + 1] = (ux - v[b]) * dx + (uy - v[b + 1]) * dy + (uz - v[b + 2]) * dz;
            squared[i + 1] = squaredLength(dx, dy, dz);

            b = others[i + 2];
            dx = ax - x[b];
            dy = ay - x[b + 1];
            dz = az - x[b + 2];
            rate[i + 2] = (ux - v[b]) * dx + (uy - v[b + 1]) * dy + (uz - v[b + 2]) * dz;
            squared[i + 2] = squaredLength(dx, dy, dz);
        }
    }

    private void gatherSingles(double[] x, int from, int to) {
        double[] squared = tension;
        for (int i = from; i < to; i++) {
            int a = own[i];
            int b = other[i];
            squared[i] = squaredLength(x[a] - x[b], x[a + 1] - x[b + 1], x[a + 2] - x[b + 2]);
        }
    }

    private void gatherDampedSingles(double[] x, double[] v, int from, int to) {
        double[] squared = tension;
        double[] rate = along;
        for (int i = from; i < to; i++) {
            int a = own[i];
            int b = other[i];
            double dx = x[a] - x[b];
            double dy = x[a + 1] - x[b + 1];
            double dz = x[a + 2] - x[b + 2];
            rate[i] = (v[a] - v[b]) * dx + (v[a + 1] - v[b + 1]) * dy + (v[a + 2] - v[b + 2]) * dz;
            squared[i] = squaredLength(dx, dy, dz);
        }
    }

    private static double squaredLength(double dx, double dy, double dz) {
        return dx * dx + dy * dy + dz * dz;
    }

    /** Gives springs of no length that are at rest a length to divide by: their forces are tension times 0. */
    private void lengthenCoincident(int from, int to) {
        for (int i = from; i < to; i++) {
            if (tension[i] == 0 && data.isAtRestWithoutLength(i)) {
                tension[i] = 1;
            }
        }
    }

    private void computeTension(int from, int to) {
        if (data.mayCoincide) {
            lengthenCoincident(from, to);
        }
        boolean damped = data.damping != 0;
        if (data.shortening == null) {
            if (damped) {
                damped(from, to);
            } else {
                elastic(from, to);
            }
        } else if (damped) {
            dampedContractile(from, to);
        } else {
            contractile(from, to);
        }
    }

    private void elastic(int from, int to) {
        double[] t = tension;
        double[] k = data.stiffness;
        double[] l = data.rest;
        for (int i = from; i < to; i++) {
            t[i] = k[i] * (1 - l[i] * (1 / Math.sqrt(t[i])));
        }
    }

    private void contractile(int from, int to) {
        double[] t = tension;
        double[] k = data.stiffness;
        double[] l = data.rest;
        double[] s = data.shortening;
        double activation = data.activation;
        for (int i = from; i < to; i++) {
            t[i] = k[i] * (1 - (l[i] - activation * s[i]) * (1 / Math.sqrt(t[i])));
        }
    }

    private void damped(int from, int to) {
        double[] t = tension;
        double[] rate = along;
        double[] k = data.stiffness;
        double[] l = data.rest;
        double c = data.damping;
        for (int i = from; i < to; i++) {
            double q = 1 / Math.sqrt(t[i]);
            t[i] = k[i] * (1 - l[i] * q) + c * (rate[i] * (q * q));
        }
    }

    private void dampedContractile(int from, int to) {
        double[] t = tension;
        double[] rate = along;
        double[] k = data.stiffness;
        double[] l = data.rest;
        double[] s = data.shortening;
        double c = data.damping;
        double activation = data.activation;
        for (int i = from; i < to; i++) {
            double q = 1 / Math.sqrt(t[i]);
            t[i] = k[i] * (1 - (l[i] - activation * s[i]) * q) + c * (rate[i] * (q * q));
        }
    }

    private void scatterStars(double[] x, double[] force, int from, int to) {
        int[] firsts = own;
        int[] others = other;
        double[] tensions = tension;
        for (int i = from; i < to; i += 3) {
            int a = firsts[i];
            double ax = x[a];
            double ay = x[a + 1];
            double az = x[a + 2];

            int b = others[i];
            double t = tensions[i];
            double sx = (ax - x[b]) * t;
            double sy = (ay - x[b + 1]) * t;
            double sz = (az - x[b + 2]) * t;
            add(force, b, sx, sy, sz);

            b = others[i + 1];
            t = tensions[i + 1];
            double fx = (ax - x[b]) * t;
            double fy = (ay - x[b + 1]) * t;
            double fz = (az - x[b + 2]) * t;
            add(force, b, fx, fy, fz);
            sx += fx;
            sy += fy;
            sz += fz;

            b = others[i + 2];
            t = tensions[i + 2];
            fx = (ax - x[b]) * t;
            fy = (ay - x[b + 1]) * t;
            fz = (az - x[b + 2]) * t;
            add(force, b, fx, fy, fz);
            subtract(force, a, sx + fx, sy + fy, sz + fz);
        }
    }

    private void scatterSingles(double[] x, double[] force, int from, int to, boolean bothEnds) {
        for (int i = from; i < to; i++) {
            int a = own[i];
            int b = other[i];
            double t = tension[i];
            double fx = (x[a] - x[b]) * t;
            double fy = (x[a + 1] - x[b + 1]) * t;
            double fz = (x[a + 2] - x[b + 2]) * t;
            subtract(force, a, fx, fy, fz);
            if (bothEnds) {
                add(force, b, fx, fy, fz);
            }
        }
    }

    static void add(double[] force, int node, double fx, double fy, double fz) {
        force[node] += fx;
        force[node + 1] += fy;
        force[node + 2] += fz;
    }

    static void subtract(double[] force, int node, double fx, double fy, double fz) {
        force[node] -= fx;
        force[node + 1] -= fy;
        force[node + 2] -= fz;
    }
}
