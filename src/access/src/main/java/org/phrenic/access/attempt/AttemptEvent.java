package org.phrenic.access.attempt;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * Something that happened in an attempt.
 *
 * @param kind what
 * @param structure the structure it happened to; empty for none
 * @param timeS simulated time, s
 * @param breath number of the breath, from 1
 * @param phase place in the breath, 0 to below 1
 * @param label what the breath did
 * @param depthMm of the tip below the skin, along the needle
 */
public record AttemptEvent(
        Kind kind, String structure, double timeS, int breath, double phase, RespiratoryPhase label, double depthMm) {
    /** What can happen. */
    public enum Kind {
        SKIN_CONTACT,
        SKIN_PUNCTURE,
        ENTERS,
        CAPSULE_PUNCTURE,
        BONE_CONTACT,
        REDIRECTION,
        SAMPLE,
        OUT_OF_SKIN
    }

    /** Plain values for a report. */
    public Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("event", kind.name().toLowerCase(Locale.ROOT));
        if (!structure.isEmpty()) {
            map.put("structure", structure);
        }
        map.put("time_s", timeS);
        map.put("breath", breath);
        map.put("phase", phase);
        map.put("breathing", label.name().toLowerCase(Locale.ROOT));
        map.put("depth_mm", depthMm);
        return map;
    }
}
