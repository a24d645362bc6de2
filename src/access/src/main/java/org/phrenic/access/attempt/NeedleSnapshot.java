package org.phrenic.access.attempt;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * A moment of an attempt, for a picture.
 *
 * @param name such as "sample"
 * @param frame of the body; a copy
 * @param label what the breath did
 * @param hub of the needle, LPS, mm
 * @param entry on the skin
 * @param tip of the needle
 * @param target its middle
 * @param targetRadiusMm its radius
 */
public record NeedleSnapshot(
        String name,
        Frame frame,
        RespiratoryPhase label,
        double[] hub,
        double[] entry,
        double[] tip,
        double[] target,
        double targetRadiusMm) {
    static NeedleSnapshot of(String name, NeedleInsertion needle, Frame frame, RespiratoryPhase label) {
        return new NeedleSnapshot(
                name,
                frame.copy(),
                label,
                needle.hubNow(),
                needle.entryNow(),
                needle.tipNow(),
                needle.targetNow(),
                needle.target().radiusMm());
    }
}
