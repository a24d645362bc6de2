package org.phrenic.ui.widget;

import java.util.function.LongSupplier;
import javax.swing.Timer;

/**
 * Lets something happen at most so often: at once if it has not happened for a while, else a little later, and then
 * only once with what is newest.
 */
public final class RateLimiter {
    /** Twenty times a second. */
    static final int INTERVAL_MS = 50;

    private static final long NS_PER_MS = 1_000_000;

    private final Runnable action;
    private final LongSupplier clockNs;
    private final Timer timer;
    private long lastRunNs;
    private boolean pending;

    /**
     * @param send what happens
     * @param clockNs a clock such as {@link System#nanoTime}
     */
    public RateLimiter(Runnable send, LongSupplier clockNs) {
        this.action = send;
        this.clockNs = clockNs;
        lastRunNs = clockNs.getAsLong() - INTERVAL_MS * NS_PER_MS;
        timer = new Timer(INTERVAL_MS, e -> flush());
        timer.setRepeats(false);
    }

    /** There is something new to send. */
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

    /** Sends now what waits; nothing if nothing does. */
    public void flush() {
        timer.stop();
        if (pending) {
            pending = false;
            lastRunNs = clockNs.getAsLong();
            action.run();
        }
    }

    /** Whether something waits. */
    public boolean isPending() {
        return pending;
    }
}
