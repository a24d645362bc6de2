package org.phrenic.access.attempt;

import java.util.Map;
import org.phrenic.document.OrderedValues;

/**
 * How the ultrasound probe was used in an attempt. Probe time and needle length in the beam tell beginners from experts
 * (Johnson et al. 2012, BJR 85:555).
 *
 * @param probeS time with the probe on the skin, s
 * @param tipUnseenS time with the tip in the body and not in the beam, s
 * @param needleInBeamMm mean length of the needle below the skin that lay in the beam, over the time in the body, mm
 * @param needleInBeamShare mean share of the needle below the skin that lay in the beam, 0 to 1
 */
public record ProbeUse(double probeS, double tipUnseenS, double needleInBeamMm, double needleInBeamShare) {
    /** Without a probe. */
    public static final ProbeUse NONE = new ProbeUse(0, 0, 0, 0);

    public boolean isUsed() {
        return probeS > 0;
    }

    /** The values in a fixed order. */
    public Map<String, Object> toMap() {
        return new OrderedValues()
                .with("probe_s", probeS)
                .with("tip_out_of_beam_s", tipUnseenS)
                .with("needle_in_beam_mm", needleInBeamMm)
                .with("needle_in_beam_share", needleInBeamShare);
    }
}
