package org.phrenic.access.attempt;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * State of an attempt at one moment, for rendering a picture. Positions are LPS, mm.
 *
 * @param name name such as "sample"
 * @param frame private copy of the frame of the body
 * @param placed whether the needle is on or in the body; else its position means nothing
 * @param hub hub of the needle
 * @param target centre of the target
 */
public record NeedleSnapshot(
        String name,
        Frame frame,
        RespiratoryPhase label,
        boolean placed,
        double[] hub,
        double[] tip,
        double[] target,
        double targetRadiusMm) {
    /** Whether it was taken for an ultrasound image instead of for views of the needle. */
    public boolean isForUltrasound() {
        return name.startsWith(NeedleSnapshots.IMAGE_PREFIX);
    }
}
