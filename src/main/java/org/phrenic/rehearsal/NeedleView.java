package org.phrenic.rehearsal;

import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Frame;

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
public record NeedleView(
        String name,
        Frame frame,
        BreathLabel label,
        double[] hub,
        double[] entry,
        double[] tip,
        double[] target,
        double targetRadiusMm) {
    static NeedleView of(String name, NeedleSession needle, Frame frame, BreathLabel label) {
        return new NeedleView(
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
