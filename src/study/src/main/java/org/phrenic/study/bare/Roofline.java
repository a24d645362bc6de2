package org.phrenic.study.bare;

import java.util.Arrays;
import org.phrenic.engine.parallel.Workers;

/**
 * What a machine could do at most of the bare workload, from two measurements of it: a step takes one root and one
 * quotient a spring, and touches each node's position and velocity (read and written) and each spring's two ends and
 * rest length (read) at least once. With both perfectly overlapped
 *
 * <pre>
 * steps/s = 1 / max(edges / rootsPerSecond, bytes / bytesPerSecond)
 * </pre>
 *
 * <p>What a real step needs besides (differences gathered from scattered nodes, forces given back to them) counts for
 * nothing here, so no program reaches it.
 *
 * @param rootsPerSecond 1/sqrt(x) of doubles in the first-level cache, all threads together
 * @param bytesPerSecond read and written, over arrays together as large as what a step touches, all threads together
 * @param stepsPerSecond the bound
 */
public record Roofline(double rootsPerSecond, double bytesPerSecond, double stepsPerSecond) {
    /** Position and velocity, read and written: 2 x 2 x 3 doubles. */
    private static final int BYTES_A_NODE = 96;
    /** Two indices and a rest length. */
    private static final int BYTES_AN_EDGE = 16;

    private static final int ROOTS = 1024;
    private static final int REPEATS = 16;
    /** A measurement ends when for so long no round was faster than all before. */
    private static final long STALL_NANOS = 150_000_000;

    /** By how much a round must be faster to count as that. */
    private static final double FASTER = 0.99;

    /**
     * Measures the machine: about half a second.
     *
     * @param nodes particles
     * @param edges springs
     * @param threads that share the work
     */
    public static Roofline measure(int nodes, int edges, int threads) {
        double bytes = (double) BYTES_A_NODE * nodes + (double) BYTES_AN_EDGE * edges;
        try (Workers workers = Workers.of(threads)) {
            double[][] small = new double[2 * threads][ROOTS];
            for (double[] values : small) {
                Arrays.fill(values, 2);
            }
            double roots = threads
                    * (double) ROOTS
                    * REPEATS
                    / fastestRoundS(workers, thread -> {
                        for (int i = 0; i < REPEATS; i++) {
                            roots(small[2 * thread], small[2 * thread + 1]);
                        }
                    });
            double[][] large = new double[2 * threads][(int) (bytes / (2.0 * Double.BYTES * threads)) + 1];
            double speed = bytes / fastestRoundS(workers, thread -> scale(large[2 * thread], large[2 * thread + 1]));
            return new Roofline(roots, speed, 1 / Math.max(edges / roots, bytes / speed));
        }
    }

    /** Least time of a round on all threads, s: what disturbs only makes it longer. */
    private static double fastestRoundS(Workers workers, Workers.Task task) {
        double least = Double.POSITIVE_INFINITY;
        long before = System.nanoTime();
        long end = before + STALL_NANOS;
        do {
            workers.run(workers.count(), task);
            long now = System.nanoTime();
            double seconds = (now - before) * 1e-9;
            if (seconds < FASTER * least) {
                end = now + STALL_NANOS;
            }
            least = Math.min(least, seconds);
            before = now;
        } while (before < end);
        return least;
    }

    private static void roots(double[] in, double[] out) {
        for (int i = 0; i < ROOTS; i++) {
            out[i] = 1 / Math.sqrt(in[i]);
        }
    }

    private static void scale(double[] in, double[] out) {
        for (int i = 0; i < in.length; i++) {
            out[i] = 3 * in[i];
        }
    }
}
