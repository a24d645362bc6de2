package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/** Stops the breath of a thorax and lets it come to rest: where it then lies is its rest shape. */
final class BreathStop {
    /** How long a body has to come to rest, s. */
    static final double SETTLING_S = 20;

    /**
     * About critical, N s/m, for the springs that bring the paper's sheet home; its own 0.02 would let it swing for a
     * minute.
     */
    static final double DAMPING = 1;

    private BreathStop() {}

    /** The changes that stop it. */
    static List<Assignment> stopChanges(Scenario scenario) {
        List<Assignment> list = new ArrayList<>();
        list.add(assignment(Parameter.DEPTH.key(), 0.0));
        if (scenario.material() == TissueMaterial.PAPER) {
            list.add(assignment(Parameter.DAMPING.key(), DAMPING));
        }
        return list;
    }

    static Assignment assignment(String key, Object value) {
        return new Assignment("slider " + key, key, String.valueOf(value));
    }
}
