package org.phrenic.access;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * The body at one moment of a breath.
 *
 * @param frame a copy of its own, read-only
 * @param label what the breath is doing
 */
public record BreathMoment(Frame frame, RespiratoryPhase label) {
    /** Simulated time, s. */
    public double timeS() {
        return frame.timeS();
    }
}
