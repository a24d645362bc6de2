package org.phrenic.engine.constraint;

/**
 * Decides when a constraint refreshes cached geometry, such as tangent planes: after an interval of simulated time, and
 * after an earlier state was restored.
 */
final class RefreshClock {
    /** Relative tolerance, so that rounding of the time does not delay a refresh by a step. */
    private static final double SLACK = 1e-9;

    private double interval;
    private double taken = Double.NaN;
    private double now = Double.NaN;

    /** @param interval simulated time between refreshes, s */
    RefreshClock(double interval) {
        this.interval = interval;
    }

    void setInterval(double seconds) {
        interval = seconds;
    }

    /** Forces a refresh at the next call of {@link #advanceTo}. */
    void invalidate() {
        now = Double.NaN;
    }

    /** Advances to a time, s; returns whether a refresh is due. */
    boolean advanceTo(double time) {
        // If time does not increase, an earlier state was restored and the cached geometry is invalid.
        boolean due = !(time > now && time - taken < interval * (1 - SLACK));
        now = time;
        if (due) {
            taken = time;
        }
        return due;
    }

    double interval() {
        return interval;
    }

    /** Time since the last refresh, s. */
    double elapsed() {
        return now - taken;
    }
}
