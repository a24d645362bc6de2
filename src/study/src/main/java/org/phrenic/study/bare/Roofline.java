package org.phrenic.study.bare;

import java.util.Arrays;
import org.phrenic.engine.parallel.Workers;

/**
 * Upper bound of a machine's speed on the bare workload, from two measurements of the machine (roofline model). Per
 * step each spring needs at least one square root and one division. Memory traffic is at least position and velocity of
 * each node, read and written, and the two ends and rest length of each spring, read. With perfect overlap of
 * computation and memory traffic
 *
 * <pre>
 * steps/s = 1 / max(edges / rootsPerSecond, bytes / bytesPerSecond)
 * </pre>
 *
 * <p>A real step also gathers differences from scattered nodes and scatters forces back to them. The bound ignores
 * this, so no program reaches it.
 *
 * @param rootsPerSecond rate of 1/sqrt(x) on doubles in the first-level cache, all threads together
 * @param bytesPerSecond memory bandwidth for reads and writes, on arrays of the same total size as one step's data, all
 *     threads together
 * @param stepsPerSecond the bound
 */
public record Roofline(double rootsPerSecond, double bytesPerSecond, double stepsPerSecond) {
    /** Position and velocity, read and written: 2 x 2 x 3 doubles. */
    private static final int BYTES_A_NODE = 96;
    /** Two indices and a rest length. */
    private static final int BYTES_AN_EDGE = 16;

    private static final int ROOTS = 1024;
    private static final int REPEATS = 16;
    /** The measurement ends after this time without a faster round. */
    private static final long STALL_NANOS = 150_000_000;

    /** A round counts as faster if it takes less than this fraction of the best time. */
    private static final double FASTER = 0.99;

    /**
     * Measures the machine, for about half a second.
     *
     * @param nodes number of particles
     * @param edges number of springs
     * @param threads number of worker threads
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

    /** Minimum time of a round on all threads, s. The minimum is used because disturbances only lengthen a round. */
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
