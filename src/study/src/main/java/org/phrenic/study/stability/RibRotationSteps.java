package org.phrenic.study.stability;

import java.util.List;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.Simulation;

/** Throws the rotation of the ribs from one end of its slider to the other, every other second. */
final class RibRotationSteps implements ThoraxScene.Intervention {
    private static final double INTERVAL_S = 2;

    private long stepsDone;

    @Override
    public void beforeStep(Simulation simulation) {
        long due = (long) Math.floor(simulation.time() / INTERVAL_S + 1e-9);
        if (due > stepsDone) {
            stepsDone = due;
            Parameter p = Parameter.RIB_ROTATION;
            double value = due % 2 == 1 ? p.maximum() : p.minimum();
            simulation.change(List.of(new Assignment("ribs thrown", p.key(), String.valueOf(value))));
        }
    }
}
