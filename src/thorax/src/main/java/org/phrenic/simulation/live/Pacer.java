package org.phrenic.simulation.live;

/** Keeps simulated time in step with wall time, and measures how fast it goes. */
final class Pacer {
    /**
     * What is more behind than this is let go: after a pause of the machine nobody wants to see the backlog in a rush.
     */
    private static final double MAX_BACKLOG_S = 0.1;

    /** What is this near to the pace asked for keeps it. */
    private static final double ON_PACE_SHARE = 0.97;

    private static final long MEASURE_NS = 250_000_000;

    private double speed = 1;
    private double anchorS;
    private long anchorNs;
    private long measuredNs;
    private long measuredSteps;
    private double measuredS;
    private double stepsPerS;
    private double realtime;

    /** Simulated seconds a second of wall time; infinite for as fast as it goes. */
    void setSpeed(double factor, double nowS) {
        speed = factor;
        resetReference(nowS);
    }

    /** Starts anew from a simulated time. */
    void resetReference(double nowS) {
        anchorS = nowS;
        anchorNs = System.nanoTime();
    }

    /** Starts measuring. */
    void start(long steps, double nowS) {
        resetReference(nowS);
        measuredNs = anchorNs;
        measuredSteps = steps;
        measuredS = nowS;
    }

    /** How long to wait, ns, before a step from this simulated time is due; 0 or less if it is. */
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

    /** Told where the run is; measures every quarter of a second. */
    void measure(long steps, double nowS) {
        long now = System.nanoTime();
        if (now - measuredNs >= MEASURE_NS) {
            double wall = (now - measuredNs) * 1e-9;
            stepsPerS = (steps - measuredSteps) / wall;
            realtime = (nowS - measuredS) / wall;
            measuredNs = now;
            measuredSteps = steps;
            measuredS = nowS;
        }
    }

    /** Whether it goes slower than it should; as fast as it goes is never fast enough. */
    boolean isBehind() {
        return realtime < ON_PACE_SHARE * speed;
    }

    double stepsPerS() {
        return stepsPerS;
    }

    double realtimeFactor() {
        return realtime;
    }
}
