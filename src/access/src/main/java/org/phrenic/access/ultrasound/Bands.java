package org.phrenic.access.ultrasound;

import java.util.stream.IntStream;

/** Computes consecutive items concurrently. */
final class Bands {
    /** Computes the items of a band. */
    interface Work {
        void compute(int from, int to);
    }

    private static final int BANDS_PER_THREAD = 4;

    private Bands() {}

    /** Computes all items in bands, each by one thread; which thread it is must not matter to the result. */
    static void run(int items, int threads, Work work) {
        if (threads <= 1) {
            work.compute(0, items);
            return;
        }
        int bands = Math.min(items, BANDS_PER_THREAD * threads);
        IntStream.range(0, bands)
                .parallel()
                .forEach(i -> work.compute((int) ((long) items * i / bands), (int) ((long) items * (i + 1) / bands)));
    }
}
