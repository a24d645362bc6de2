package org.phrenic.study.speed;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.function.IntConsumer;

/** Measures steps per second: by processor time for one thread, by elapsed time for several. */
final class StepTimer {
    private final IntConsumer advance;
    private final boolean usesProcessorTime;

    /** @param advance performs a number of steps */
    StepTimer(int threads, IntConsumer advance) {
        this.advance = advance;
        usesProcessorTime = threads == 1 && ManagementFactory.getThreadMXBean().isCurrentThreadCpuTimeSupported();
    }

    /** Steps per second over approximately {@code seconds}; used as warm-up. */
    double rateOver(double seconds) {
        long begun = nanos();
        int steps = 0;
        do {
            advance.accept(1);
            steps++;
        } while ((nanos() - begun) * 1e-9 < seconds);
        return steps / ((nanos() - begun) * 1e-9);
    }

    /** Steps per second over a number of steps. */
    double rate(int steps) {
        long begun = nanos();
        advance.accept(steps);
        return steps / ((nanos() - begun) * 1e-9);
    }

    private long nanos() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return usesProcessorTime ? threads.getCurrentThreadCpuTime() : System.nanoTime();
    }
}
