package org.phrenic.engine.force;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * The kernel that is fastest here and now, by trying each on the springs at hand: which it is depends on processor and
 * Java version (vector instructions by name are in some shapes a fifth as fast as plain loops). Kernels give the same
 * bits, so the choice shows in nothing but time.
 */
final class KernelChoice {
    /** Enough for the just-in-time compiler to have settled in the later ones: the least time of all counts. */
    private static final int ROUNDS = 10;

    private static final long ROUND_NANOS = 8_000_000;

    private KernelChoice() {}

    /**
     * Tries all in turns and leaves the fastest set; takes no time where there is only one.
     *
     * @param springs the springs
     * @param evaluate computes all their forces once
     */
    static SpringKernel fastest(Springs springs, Runnable evaluate) {
        List<SpringKernel> candidates = SpringKernel.available();
        SpringKernel best = candidates.get(0);
        if (candidates.size() > 1) {
            Map<SpringKernel, Long> least = new EnumMap<>(SpringKernel.class);
            for (int round = 0; round < ROUNDS; round++) {
                for (SpringKernel kernel : candidates) {
                    springs.setKernel(kernel);
                    least.merge(kernel, leastNanos(evaluate), Math::min);
                }
            }
            for (SpringKernel kernel : candidates) {
                best = least.get(kernel) < least.get(best) ? kernel : best;
            }
        }
        springs.setKernel(best);
        return best;
    }

    /** Least time of an evaluation in a round: what other programs do only makes it longer. */
    private static long leastNanos(Runnable evaluate) {
        long before = System.nanoTime();
        long end = before + ROUND_NANOS;
        long least = Long.MAX_VALUE;
        do {
            evaluate.run();
            long now = System.nanoTime();
            least = Math.min(least, now - before);
            before = now;
        } while (before < end);
        return least;
    }
}
