package org.phrenic.access.live;

/**
 * The steps of a run that a needle has taken note of, where the frame of a step may come after later steps. Times are
 * in s.
 */
final class StepOrder {
    private double lastS;
    private double lateS = Double.NaN;

    /** Takes note of a step without its frame. Returns whether the run has begun anew before it. */
    boolean step(double timeS) {
        boolean anew = timeS < lastS;
        lastS = timeS;
        return anew;
    }

    /** States that the frame of a step comes later. */
    void comesLater(double timeS) {
        lateS = timeS;
    }

    /** Takes note of a frame. Returns whether the run has begun anew before it. */
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
