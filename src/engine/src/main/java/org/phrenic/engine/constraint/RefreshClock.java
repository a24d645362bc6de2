package org.phrenic.engine.constraint;

/**
 * When a constraint takes anew what it keeps of the shape it works on, such as tangent planes: after an interval of
 * simulated time, and when an earlier state was put back.
 */
final class RefreshClock {
    /** Rounding of the time must not shift a refresh by a step. */
    private static final double SLACK = 1e-9;

    private double interval;
    private double taken = Double.NaN;
    private double now = Double.NaN;

    /** @param interval simulated time between two, s */
    RefreshClock(double interval) {
        this.interval = interval;
    }

    void setInterval(double seconds) {
        interval = seconds;
    }

    /** At the next time, whichever it is, all is taken anew. */
    void invalidate() {
        now = Double.NaN;
    }

    /** Goes on to a time, s; says whether all is taken anew there. */
    boolean advanceTo(double time) {
        // A time that does not move on means that an earlier state was put back: what is known of the lost one is
        // worth nothing.
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

    /** Time since all was taken anew, s. */
    double elapsed() {
        return now - taken;
    }
}
