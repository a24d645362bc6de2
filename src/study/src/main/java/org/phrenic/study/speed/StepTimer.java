package org.phrenic.study.speed;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.function.IntConsumer;

/** Measures steps a second: by processor time where one thread computes, by the clock where several do. */
final class StepTimer {
    private final IntConsumer advance;
    private final boolean usesProcessorTime;

    /** @param advance does so many steps */
    StepTimer(int threads, IntConsumer advance) {
        this.advance = advance;
        usesProcessorTime = threads == 1 && ManagementFactory.getThreadMXBean().isCurrentThreadCpuTimeSupported();
    }

    /** Steps a second over a stretch of about so many seconds: the warm-up. */
    double rateOver(double seconds) {
        long begun = nanos();
        int steps = 0;
        do {
            advance.accept(1);
            steps++;
        } while ((nanos() - begun) * 1e-9 < seconds);
        return steps / ((nanos() - begun) * 1e-9);
    }

    /** Steps a second over so many steps. */
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
