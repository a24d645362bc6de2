package org.phrenic.study.speed;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import org.phrenic.study.bare.BareScene;
import org.phrenic.study.bare.BareSettings;
import org.phrenic.study.bare.BareWorkload;

/** Times steps of the bare workload on one scene: processor time on one thread, the clock on several. */
final class ScalingTrials {
    private ScalingTrials() {}

    /**
     * Measures.
     *
     * @param trials of which the median counts
     * @param trialS what a trial takes at least, s
     */
    static SizeScaling.Row of(BareScene scene, int threads, int trials, double trialS) {
        try (BareWorkload work = new BareWorkload(scene, BareSettings.DEFAULT.withThreads(threads))) {
            String kernel = work.useFastestKernel().label();
            int steps = Math.max(3, (int) (trialS * warmUp(work, threads, trialS)));
            rate(work, threads, steps);
            double[] rates = new double[trials];
            for (int i = 0; i < trials; i++) {
                rates[i] = rate(work, threads, steps);
            }
            Arrays.sort(rates);
            return new SizeScaling.Row(work.nodeCount(), work.edgeCount(), threads, kernel, rates[trials / 2]);
        }
    }

    /** Steps a second over a stretch of about so many seconds. */
    private static double warmUp(BareWorkload work, int threads, double seconds) {
        long begun = nanos(threads);
        int steps = 0;
        do {
            work.advance(1);
            steps++;
        } while ((nanos(threads) - begun) * 1e-9 < seconds);
        return steps / ((nanos(threads) - begun) * 1e-9);
    }

    private static double rate(BareWorkload work, int threads, int steps) {
        long begun = nanos(threads);
        work.advance(steps);
        return steps / ((nanos(threads) - begun) * 1e-9);
    }

    private static long nanos(int threads) {
        ThreadMXBean clock = ManagementFactory.getThreadMXBean();
        return threads == 1 && clock.isCurrentThreadCpuTimeSupported()
                ? clock.getCurrentThreadCpuTime()
                : System.nanoTime();
    }
}
