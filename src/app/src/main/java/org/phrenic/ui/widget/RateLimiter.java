package org.phrenic.ui.widget;

import java.util.function.LongSupplier;
import javax.swing.Timer;

/**
 * Limits the rate of an action: it runs at once if the last run is long enough ago, else once after the rest of the
 * interval. For the event dispatch thread.
 */
public final class RateLimiter {
    static final int INTERVAL_MS = 50;

    private static final long NS_PER_MS = 1_000_000;

    private final Runnable action;
    private final LongSupplier clockNs;
    private final Timer timer;
    private long lastRunNs;
    private boolean pending;

    /** @param clockNs a clock such as {@link System#nanoTime} */
    public RateLimiter(Runnable send, LongSupplier clockNs) {
        this.action = send;
        this.clockNs = clockNs;
        lastRunNs = clockNs.getAsLong() - INTERVAL_MS * NS_PER_MS;
        timer = new Timer(INTERVAL_MS, e -> flush());
        timer.setRepeats(false);
    }

    public void request() {
        pending = true;
        long waitNs = lastRunNs + INTERVAL_MS * NS_PER_MS - clockNs.getAsLong();
        if (waitNs <= 0) {
            flush();
        } else if (!timer.isRunning()) {
            timer.setInitialDelay((int) (waitNs / NS_PER_MS) + 1);
            timer.start();
        }
    }

    /** Runs a pending action at once. */
    public void flush() {
        timer.stop();
        if (pending) {
            pending = false;
            lastRunNs = clockNs.getAsLong();
            action.run();
        }
    }

    public boolean isPending() {
        return pending;
    }
}
