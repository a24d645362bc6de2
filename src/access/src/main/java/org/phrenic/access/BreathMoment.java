package org.phrenic.access;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * The state of the body at one moment of a breath.
 *
 * @param frame private copy, read-only
 * @param label phase of the breath
 * @param periodS period of the breathing, of one breath or of several, s
 */
public record BreathMoment(Frame frame, RespiratoryPhase label, double periodS) {
    /** Simulated time, s. */
    public double timeS() {
        return frame.timeS();
    }
}
