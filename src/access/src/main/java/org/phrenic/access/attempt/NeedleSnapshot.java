package org.phrenic.access.attempt;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * A moment of an attempt, for a picture. Positions LPS, mm.
 *
 * @param name such as "sample"
 * @param frame of the body; a copy
 * @param hub of the needle
 * @param entry on the skin
 * @param target centre of the target
 */
public record NeedleSnapshot(
        String name,
        Frame frame,
        RespiratoryPhase label,
        double[] hub,
        double[] entry,
        double[] tip,
        double[] target,
        double targetRadiusMm) {}
