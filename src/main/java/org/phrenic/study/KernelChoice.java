package org.phrenic.study;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import org.phrenic.engine.force.SpringKernel;

/**
 * The kernel that is fastest here and now, by trying each: which it is depends on processor and Java version (vector instructions by name are in some shapes a fifth as fast as plain loops).
 * Kernels give the same bits, so the choice shows in nothing but time.
 */
final class KernelChoice {
    private static final int WARM_UP_ROUNDS = 4;
    private static final int ROUNDS = 10;
    private static final long ROUND_NANOS = 30_000_000;

    private KernelChoice() {}

    /**
     * Tries all kernels in turns and leaves the fastest set.
     *
     * @param set makes the work use a kernel
     * @param step does a step of the work
     */
    static SpringKernel fastest(Consumer<SpringKernel> set, Runnable step) {
        Map<SpringKernel, Double> least = new EnumMap<>(SpringKernel.class);
        for (int round = 0; round < ROUNDS; round++) {
            for (SpringKernel kernel : SpringKernel.available()) {
                if (kernel == SpringKernel.REFERENCE) {
                    continue;
                }
                set.accept(kernel);
                double time = leastStep(step);
                if (round >= WARM_UP_ROUNDS) {
                    least.merge(kernel, time, Math::min);
                }
            }
        }
        SpringKernel best = least.entrySet().stream()
                .min(Map.Entry.comparingByValue())
                .orElseThrow()
                .getKey();
        set.accept(best);
        return best;
    }

    /** Least time of a step in a round: other programs only make it longer. */
    private static double leastStep(Runnable step) {
        long end = System.nanoTime() + ROUND_NANOS;
        long before = System.nanoTime();
        long least = Long.MAX_VALUE;
        do {
            step.run();
            long now = System.nanoTime();
            least = Math.min(least, now - before);
            before = now;
        } while (before < end);
        return least * 1e-9;
    }
}
