package org.phrenic.study.hard;

import java.util.List;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Simulation;

/** Throws the rotation of the ribs from one end of its slider to the other, every other second. */
final class RibThrow implements ThoraxTrial.Doing {
    private static final double EVERY_S = 2;

    private long thrown;

    @Override
    public void before(Simulation simulation) {
        long due = (long) Math.floor(simulation.time() / EVERY_S + 1e-9);
        if (due > thrown) {
            thrown = due;
            Parameter p = Parameter.RIB_ROTATION;
            double value = due % 2 == 1 ? p.maximum() : p.minimum();
            simulation.change(List.of(new Assignment("ribs thrown", p.key(), String.valueOf(value))));
        }
    }
}
