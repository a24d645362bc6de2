package org.phrenic.simulation.live;

/**
 * Chooses whether the steps of a live run use one thread or all, from the rates measured with either. It begins with
 * one, which leaves the other cores to the window. While the run is behind its pace, it tries the other way for
 * {@value #TRIAL} measurements and keeps it if it is faster, or if all threads catch up with the pace. The time between
 * trials doubles with each that gains nothing.
 */
final class ThreadChooser {
    /** Measurements behind the pace before the first trial. */
    static final int FIRST_WAIT = 3;

    static final int MAX_WAIT = 120;

    /**
     * Measurements in a row that keep the pace after which those behind it are forgotten. Drawing that gives way makes
     * a run catch up for a moment.
     */
    static final int ON_PACE = 8;

    /** Measurements of a trial; the first is not counted, because it falls into both ways. */
    static final int TRIAL = 3;

    /** Rate over the other way's from which it is kept. */
    static final double GAIN = 1.05;

    private boolean allThreads;
    private boolean trying;
    private int behindFor;
    private int onPaceFor;
    private int wait = FIRST_WAIT;
    private int triedFor;
    private double usualRate;
    private double triedRate;

    /** Whether all threads are used. */
    boolean allThreads() {
        return allThreads;
    }

    /** Starts again with one thread, for another scene. */
    void reset() {
        allThreads = false;
        trying = false;
        behindFor = 0;
        wait = FIRST_WAIT;
    }

    /**
     * Takes a measurement.
     *
     * @param rate simulated over wall time since the last one
     * @param behind whether this is less than the pace asked for
     */
    void measured(double rate, boolean behind) {
        if (trying) {
            triedFor++;
            triedRate = triedFor > 1 ? Math.max(triedRate, rate) : 0;
            if (triedFor >= TRIAL) {
                endTrial(behind);
            }
        } else if (behind) {
            onPaceFor = 0;
            usualRate = behindFor == 0 ? rate : Math.max(usualRate, rate);
            if (++behindFor >= wait) {
                trying = true;
                triedFor = 0;
                allThreads = !allThreads;
            }
        } else if (++onPaceFor >= ON_PACE) {
            behindFor = 0;
        }
    }

    private void endTrial(boolean behind) {
        trying = false;
        behindFor = 0;
        if ((allThreads && !behind) || triedRate >= GAIN * usualRate) {
            wait = FIRST_WAIT;
        } else {
            allThreads = !allThreads;
            wait = Math.min(MAX_WAIT, 2 * wait);
        }
    }
}
