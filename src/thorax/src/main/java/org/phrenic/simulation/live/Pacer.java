package org.phrenic.simulation.live;

import java.util.function.LongSupplier;

/**
 * Limits the rate of simulated time relative to wall time, and measures the actual rate. A backlog is made up for at
 * {@value #CATCH_UP} times the requested rate, so that motion after a stall is hardly faster than asked for.
 */
final class Pacer {
    /** Largest backlog that is made up for, wall time, s. A longer one, as after a pause of the machine, is dropped. */
    static final double MAX_BACKLOG_S = 1;

    /** Largest rate over the requested one. */
    static final double CATCH_UP = 1.15;

    /** Largest backlog of the largest rate, wall time, s. */
    private static final double MAX_BURST_S = 0.1;

    /** Share of the requested rate that counts as keeping pace. */
    private static final double ON_PACE_SHARE = 0.97;

    private static final long MEASURE_NS = 250_000_000;

    /** Share of the last measurement in the rate that tells whether the pace is kept: a mean over about two seconds. */
    private static final double LATEST_SHARE = 0.125;

    private final LongSupplier clock;
    private double speed = 1;
    private final Reference requested = new Reference(MAX_BACKLOG_S);
    private final Reference largest = new Reference(MAX_BURST_S);
    private long measuredNs;
    private long measuredSteps;
    private double measuredS;
    private double stepsPerS;
    private double realtime;
    private double meanRealtime;

    /** A simulated time and the wall time at which it was due. */
    private static final class Reference {
        private final double maxBacklogS;
        private double simulatedS;
        private long wallNs;

        Reference(double maxBacklogS) {
            this.maxBacklogS = maxBacklogS;
        }

        void set(double nowS, long nowNs) {
            simulatedS = nowS;
            wallNs = nowNs;
        }

        /** Time until a step from this simulated time is due at a rate, ns; a backlog beyond the largest is dropped. */
        double waitNs(double nowS, long nowNs, double rate) {
            double wait = wallNs + (nowS - simulatedS) / rate * 1e9 - nowNs;
            if (wait < -maxBacklogS * 1e9) {
                set(nowS, nowNs);
                return 0;
            }
            return wait;
        }
    }

    Pacer() {
        this(System::nanoTime);
    }

    /** @param clock wall time, ns */
    Pacer(LongSupplier clock) {
        this.clock = clock;
    }

    /** Sets the simulated seconds per second of wall time; infinite for no limit. */
    void setSpeed(double factor, double nowS) {
        speed = factor;
        resetReference(nowS);
    }

    /** Restarts pacing at a simulated time. */
    void resetReference(double nowS) {
        long nowNs = clock.getAsLong();
        requested.set(nowS, nowNs);
        largest.set(nowS, nowNs);
    }

    /** Starts the measurement. */
    void start(long steps, double nowS) {
        resetReference(nowS);
        measuredNs = requested.wallNs;
        measuredSteps = steps;
        measuredS = nowS;
        meanRealtime = Double.isInfinite(speed) ? 0 : speed;
    }

    /** Time to wait, ns, until a step from this simulated time is due; 0 or less if it is due. */
    long waitNs(double nowS) {
        if (Double.isInfinite(speed)) {
            return 0;
        }
        long nowNs = clock.getAsLong();
        double wait = Math.max(requested.waitNs(nowS, nowNs, speed), largest.waitNs(nowS, nowNs, CATCH_UP * speed));
        return (long) Math.ceil(wait);
    }

    /** Reports progress; the rate is updated every quarter of a second. Returns whether it was. */
    boolean measure(long steps, double nowS) {
        long now = clock.getAsLong();
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

    /** Whether the pace is not kept at present either: what lags behind after a stall may run ahead of the pace. */
    boolean isSlow() {
        return isBehind() && realtime < speed;
    }

    double stepsPerS() {
        return stepsPerS;
    }

    double realtimeFactor() {
        return realtime;
    }
}
