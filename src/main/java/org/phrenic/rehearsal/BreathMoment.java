package org.phrenic.rehearsal;

import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Frame;

/**
 * The body at one moment of a breath.
 *
 * @param frame a copy of its own, never written to
 * @param label what the breath is doing
 */
public record BreathMoment(Frame frame, BreathLabel label) {
    /** Simulated time, s. */
    public double timeS() {
        return frame.timeS();
    }
}
