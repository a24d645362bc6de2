package org.phrenic.simulation.assembly;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import org.phrenic.scenario.Scenario;

/** One {@link RampedValue} a {@link Knob}. */
public final class RampedValues {
    private static final Knob[] MATERIAL =
            Arrays.stream(Knob.values()).filter(Knob::affectsTissue).toArray(Knob[]::new);

    private final Map<Knob, RampedValue> values = new EnumMap<>(Knob.class);

    public RampedValues(Scenario scenario) {
        for (Knob knob : Knob.values()) {
            values.put(knob, new RampedValue(knob.valueIn(scenario)));
        }
    }

    RampedValue of(Knob knob) {
        return values.get(knob);
    }

    /** Whether all that changes springs, masses and damping has arrived. */
    boolean hasTissueArrived(double timeS) {
        for (Knob knob : MATERIAL) {
            if (!values.get(knob).hasArrived(timeS)) {
                return false;
            }
        }
        return true;
    }

    /** Whether anything else that is set step by step has arrived. */
    boolean hasGeometryArrived(double timeS) {
        return values.get(Knob.LINE_RADIUS).hasArrived(timeS)
                && values.get(Knob.LINKS).hasArrived(timeS)
                && values.get(Knob.CONTACT).hasArrived(timeS);
    }
}
