package org.phrenic.access.live;

/**
 * Order of the steps and frames that a needle gets: the frame of a step may arrive after later steps. Detects a restart
 * by a step whose time is not after that of the last one. Times are in s, from 0 on.
 */
final class StepOrder {
    private double lastS;
    private double lateS = Double.NaN;

    /** Takes note of a step without its frame. Returns whether the run has restarted. */
    boolean step(double timeS) {
        boolean restarted = timeS <= lastS;
        lastS = timeS;
        return restarted;
    }

    /** States that the frame of a step comes later, if at all. */
    void comesLater(double timeS) {
        lateS = timeS;
    }

    /** Takes note of a frame. Returns whether the run has restarted. */
    boolean frame(double timeS) {
        boolean late = timeS == lateS;
        lateS = Double.NaN;
        return !late && step(timeS);
    }

    /** Whether a step is the last one that was taken note of. */
    boolean isLast(double timeS) {
        return timeS == lastS;
    }
}
