package org.phrenic.ui.view;

/** Counts frames over the last second. */
final class FrameRateCounter {
    private static final int MAX_FRAMES = 128;
    private static final long WINDOW_NS = 1_000_000_000L;

    private final long[] times = new long[MAX_FRAMES];
    private int count;

    void count(long nowNs) {
        times[count++ % MAX_FRAMES] = nowNs;
    }

    /** Frames in the second before this time. */
    double perSecond(long nowNs) {
        int seen = 0;
        for (int i = 1; i <= Math.min(count, MAX_FRAMES); i++) {
            if (nowNs - times[(count - i) % MAX_FRAMES] > WINDOW_NS) {
                break;
            }
            seen++;
        }
        return seen;
    }
}
