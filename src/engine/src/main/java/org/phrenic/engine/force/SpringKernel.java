package org.phrenic.engine.force;

import org.phrenic.engine.parallel.BlockedEdges;

/**
 * Fused gather-compute-scatter kernels of springs: each edge is read, its force computed and added to its ends in one
 * loop. With d = x(b) - x(a), u = v(b) - v(a) and the rest length L at the current activation:
 *
 * <pre>
 * q = 1 / |d|,   t = k (1 - L q) + c (u·d) (q q),   f = t d on a, -f on b
 * </pre>
 *
 * <p>Operations are rounded one by one in this order. Each kind of spring has its own kernel, so that none reads data
 * it does not need: a step is limited by memory bandwidth as much as by arithmetic.
 */
abstract class SpringKernel {
    /** First and second node of each entry times 3. */
    final int[] own;

    final int[] other;
    /** Stiffness, N/m. */
    final double[] stiffness;
    /** Rest length, mm; see {@link SpringData#currentRest}. */
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

    /** Adds forces on both ends for the entries {@code [from, to)}, in groups of three with the same first node. */
    abstract void stars(double[] x, double[] v, double[] force, int from, int to);

    /** Adds forces for any entries, on the first node, and on the second node if {@code bothEnds}. */
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
