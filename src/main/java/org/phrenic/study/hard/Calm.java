package org.phrenic.study.hard;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Material;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;

/** Stops the breath of a thorax and lets it come to rest: where it then lies is its rest shape. */
final class Calm {
    /** How long a body has to come to rest, s. */
    static final double SECONDS = 20;

    /** About critical, N s/m, for the springs that bring the paper's sheet home; its own 0.02 would let it swing for a minute. */
    static final double DAMPING = 1;

    private Calm() {}

    /** The changes that stop it. */
    static List<Assignment> stop(Scenario scenario) {
        List<Assignment> list = new ArrayList<>();
        list.add(set(Parameter.DEPTH.key(), 0.0));
        if (scenario.material() == Material.PAPER) {
            list.add(set(Parameter.DAMPING.key(), DAMPING));
        }
        return list;
    }

    static Assignment set(String key, Object value) {
        return new Assignment("slider " + key, key, String.valueOf(value));
    }
}
