package org.phrenic.access.attempt;

import java.util.Locale;
import java.util.Map;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.document.OrderedValues;

/**
 * An event during an attempt.
 *
 * @param structure structure involved; empty if none
 * @param timeS simulated time, s
 * @param breath number of the breath, starting at 1
 * @param position position in the breath, in [0, 1)
 * @param phase phase of the breath
 * @param depthMm depth of the tip, or of the core that is thrown, below the skin, along the needle
 */
public record AttemptEvent(
        Kind kind,
        String structure,
        double timeS,
        int breath,
        double position,
        RespiratoryPhase phase,
        double depthMm) {
    /** Kinds of events. */
    public enum Kind {
        SKIN_CONTACT,
        SKIN_PUNCTURE,
        ENTERS,
        CAPSULE_PUNCTURE,
        BONE_CONTACT,
        REDIRECTION,
        SAMPLE,
        CORE_ENTERS,
        OUT_OF_SKIN
    }

    public Map<String, Object> toMap() {
        OrderedValues map = new OrderedValues().with("event", kind.name().toLowerCase(Locale.ROOT));
        if (!structure.isEmpty()) {
            map.put("structure", structure);
        }
        return map.with("time_s", timeS)
                .with("breath", breath)
                .with("phase", position)
                .with("breathing", phase.label())
                .with("depth_mm", depthMm);
    }
}
