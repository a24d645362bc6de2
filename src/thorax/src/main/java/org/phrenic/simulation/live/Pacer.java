package org.phrenic.simulation.live;

/** Limits the rate of simulated time relative to wall time, and measures the actual rate. */
final class Pacer {
    /**
     * Largest backlog that is made up for. A longer one, as after a pause of the machine, is dropped instead of
     * replayed at high speed.
     */
    private static final double MAX_BACKLOG_S = 0.1;

    /** Share of the requested rate that counts as keeping pace. */
    private static final double ON_PACE_SHARE = 0.97;

    private static final long MEASURE_NS = 250_000_000;

    /** Share of the last measurement in the rate that tells whether the pace is kept: a mean over about two seconds. */
    private static final double LATEST_SHARE = 0.125;

    private double speed = 1;
    private double anchorS;
    private long anchorNs;
    private long measuredNs;
    private long measuredSteps;
    private double measuredS;
    private double stepsPerS;
    private double realtime;
    private double meanRealtime;

    /** Sets the simulated seconds per second of wall time; infinite for no limit. */
    void setSpeed(double factor, double nowS) {
        speed = factor;
        resetReference(nowS);
    }

    /** Restarts pacing at a simulated time. */
    void resetReference(double nowS) {
        anchorS = nowS;
        anchorNs = System.nanoTime();
    }

    /** Starts the measurement. */
    void start(long steps, double nowS) {
        resetReference(nowS);
        measuredNs = anchorNs;
        measuredSteps = steps;
        measuredS = nowS;
        meanRealtime = Double.isInfinite(speed) ? 0 : speed;
    }

    /** Time to wait, ns, until a step from this simulated time is due; 0 or less if it is due. */
    long waitNs(double nowS) {
        if (Double.isInfinite(speed)) {
            return 0;
        }
        double dueNs = anchorNs + (nowS - anchorS) / speed * 1e9;
        double wait = dueNs - System.nanoTime();
        if (wait < -MAX_BACKLOG_S * 1e9) {
            resetReference(nowS);
            return 0;
        }
        return (long) Math.ceil(wait);
    }

    /** Reports progress; the rate is updated every quarter of a second. Returns whether it was. */
    boolean measure(long steps, double nowS) {
        long now = System.nanoTime();
        boolean due = now - measuredNs >= MEASURE_NS;
        if (due) {
            double wall = (now - measuredNs) * 1e-9;
            stepsPerS = (steps - measuredSteps) / wall;
            realtime = (nowS - measuredS) / wall;
            meanRealtime += LATEST_SHARE * (realtime - meanRealtime);
            measuredNs = now;
            measuredSteps = steps;
            measuredS = nowS;
        }
        return due;
    }

    /** Whether the mean rate is below the requested one. Always true without a limit. */
    boolean isBehind() {
        return meanRealtime < ON_PACE_SHARE * speed;
    }

    double stepsPerS() {
        return stepsPerS;
    }

    double realtimeFactor() {
        return realtime;
    }
}
