package org.phrenic.engine.force;

import org.phrenic.engine.parallel.BlockedEdges;

/**
 * Forces of springs, fused loops that gather both ends of an edge, compute its force and scatter it. With d = x(b) -
 * x(a), u = v(b) - v(a) and the rest length L at the present activation
 *
 * <pre>
 * q = 1 / |d|,   t = k (1 - L q) + c (u·d) (q q),   f = t d on a, -f on b
 * </pre>
 *
 * <p>Operations are rounded one by one in this order. There is a kernel a kind of springs, so that none reads what it
 * does not need: a step waits for memory as much as for arithmetic.
 */
abstract class SpringKernel {
    /** First and other node of each entry times 3. */
    final int[] own;

    final int[] other;
    /** N/m. */
    final double[] stiffness;
    /** {@link SpringData#currentRest}, mm. */
    final double[] rest;

    SpringKernel(BlockedEdges edges, SpringData data) {
        own = edges.own;
        other = edges.other;
        stiffness = data.stiffness;
        rest = data.currentRest;
    }

    static SpringKernel of(BlockedEdges edges, SpringData data) {
        if (data.damping != 0) {
            return new DampedKernel(edges, data);
        }
        return data.shortening == null ? new ElasticKernel(edges, data) : new ContractileKernel(edges, data);
    }

    /** Entries from {@code from} to before {@code to}, of which three in a row have the same first node; both ends. */
    abstract void stars(double[] x, double[] v, double[] force, int from, int to);

    /** Any entries; forces on first nodes, and on the other nodes if {@code bothEnds}. */
    abstract void singles(double[] x, double[] v, double[] force, int from, int to, boolean bothEnds);

    static double inverseLength(double dx, double dy, double dz) {
        return 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
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
