package org.phrenic.ui;

/** Counts pictures over the last second. */
final class FrameRate {
    private static final int MOST = 128;
    private static final long WINDOW_NS = 1_000_000_000L;

    private final long[] times = new long[MOST];
    private int count;

    /** A picture at this time. */
    void count(long nowNs) {
        times[count++ % MOST] = nowNs;
    }

    /** Pictures in the second before this time. */
    double perSecond(long nowNs) {
        int seen = 0;
        for (int i = 1; i <= Math.min(count, MOST); i++) {
            if (nowNs - times[(count - i) % MOST] > WINDOW_NS) {
                break;
            }
            seen++;
        }
        return seen;
    }
}
