package org.phrenic.simulation;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;

/** One {@link Dial} a {@link Knob}. */
final class Dials {
    private static final Knob[] MATERIAL =
            Arrays.stream(Knob.values()).filter(Knob::isMaterial).toArray(Knob[]::new);

    private final Map<Knob, Dial> dials = new EnumMap<>(Knob.class);

    Dials(Scenario scenario) {
        for (Knob knob : Knob.values()) {
            dials.put(knob, new Dial(knob.in(scenario)));
        }
    }

    Dial of(Knob knob) {
        return dials.get(knob);
    }

    /** Whether all that changes springs, masses and damping has arrived. */
    boolean isMaterialDone(double timeS) {
        for (Knob knob : MATERIAL) {
            if (!dials.get(knob).isDone(timeS)) {
                return false;
            }
        }
        return true;
    }

    /** Whether anything else that is set step by step has arrived. */
    boolean isGeometryDone(double timeS) {
        return dials.get(Knob.LINE_RADIUS).isDone(timeS)
                && dials.get(Knob.LINKS).isDone(timeS)
                && dials.get(Knob.CONTACT).isDone(timeS);
    }
}
