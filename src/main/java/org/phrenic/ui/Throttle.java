package org.phrenic.ui;

import java.util.function.LongSupplier;
import javax.swing.Timer;

/** Lets something happen at most so often: at once if it has not happened for a while, else a little later, and then only once with what is newest. */
final class Throttle {
    /** Twenty times a second. */
    static final int INTERVAL_MS = 50;

    private static final long NS_PER_MS = 1_000_000;

    private final Runnable send;
    private final LongSupplier clockNs;
    private final Timer timer;
    private long sentNs;
    private boolean pending;

    /**
     * @param send what happens
     * @param clockNs a clock such as {@link System#nanoTime}
     */
    Throttle(Runnable send, LongSupplier clockNs) {
        this.send = send;
        this.clockNs = clockNs;
        sentNs = clockNs.getAsLong() - INTERVAL_MS * NS_PER_MS;
        timer = new Timer(INTERVAL_MS, e -> flush());
        timer.setRepeats(false);
    }

    /** There is something new to send. */
    void request() {
        pending = true;
        long waitNs = sentNs + INTERVAL_MS * NS_PER_MS - clockNs.getAsLong();
        if (waitNs <= 0) {
            flush();
        } else if (!timer.isRunning()) {
            timer.setInitialDelay((int) (waitNs / NS_PER_MS) + 1);
            timer.start();
        }
    }

    /** Sends now what waits; nothing if nothing does. */
    void flush() {
        timer.stop();
        if (pending) {
            pending = false;
            sentNs = clockNs.getAsLong();
            send.run();
        }
    }

    /** Whether something waits. */
    boolean isPending() {
        return pending;
    }
}
