package org.phrenic.access;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * The state of the body at one moment of a breath.
 *
 * @param frame private copy, read-only
 * @param label phase of the breath
 */
public record BreathMoment(Frame frame, RespiratoryPhase label) {
    /** Simulated time, s. */
    public double timeS() {
        return frame.timeS();
    }
}
