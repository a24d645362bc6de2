package org.phrenic.engine.force;

import java.util.List;
import org.phrenic.engine.parallel.BlockedEdges;

/**
 * Forces of springs in plain loops that read both ends of an edge, compute and give in one go: with d = x(b) - x(a), u
 * = v(b) - v(a) and the rest length L = l0 - a s
 *
 * <pre>
 * q = 1 / |d|,   t = k (1 - L q) + c (u·d) (q q),   f = t d on a, -f on b
 * </pre>
 *
 * <p>Operations are done in this order and rounded one by one; whoever computes springs in another way gives the same
 * bits. Reading and giving hide behind the root and the quotient here; in passes over a batch, which the compiler turns
 * into vector instructions, the same work took a fifth longer.
 *
 * <p>There is a class for each kind of springs, so that none reads what it does not need: a step waits for memory as
 * much as for arithmetic. All constants of an edge have the edge's own index: one that is a register less costs more
 * than one that is a number more.
 */
final class EdgeLoops {
    /** The loop over some entries of one kind of springs. */
    @FunctionalInterface
    interface Loop {
        /**
         * @param batch where positions, velocities and forces are at hand
         * @param edges their ends
         * @param c their constants
         * @param from first entry
         * @param to behind the last
         */
        void run(EdgeBatch batch, BlockedEdges edges, SpringData c, int from, int to);
    }

    private EdgeLoops() {}

    /** Passes over entries of which three in a row have the same first node; forces on both ends. */
    static List<EdgeBatch.Pass> stars(BlockedEdges edges, SpringData c) {
        return passes(edges, c, ElasticKernel::stars, ContractileKernel::stars, DampedKernel::stars);
    }

    /** Passes over any entries; forces on both ends. */
    static List<EdgeBatch.Pass> both(BlockedEdges edges, SpringData c) {
        return passes(edges, c, ElasticKernel::both, ContractileKernel::both, DampedKernel::both);
    }

    /** Passes over any entries; forces on first ends. */
    static List<EdgeBatch.Pass> first(BlockedEdges edges, SpringData c) {
        return passes(edges, c, ElasticKernel::first, ContractileKernel::first, DampedKernel::first);
    }

    private static List<EdgeBatch.Pass> passes(
            BlockedEdges edges, SpringData c, Loop elastic, Loop contractile, Loop damped) {
        if (c.damping != 0) {
            return List.of(
                    (t, from, n) -> c.updateRest(from, from + n),
                    (t, from, n) -> damped.run(t, edges, c, from, from + n));
        }
        Loop loop = c.shortening == null ? elastic : contractile;
        return List.of((t, from, n) -> loop.run(t, edges, c, from, from + n));
    }

    static double inverseLength(double dx, double dy, double dz) {
        return 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    static void give(double[] force, int node, double fx, double fy, double fz) {
        force[node] += fx;
        force[node + 1] += fy;
        force[node + 2] += fz;
    }

    static void take(double[] force, int node, double fx, double fy, double fz) {
        force[node] -= fx;
        force[node + 1] -= fy;
        force[node + 2] -= fz;
    }
}
