package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.TissueMass;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;

/** A thorax of the program and what is changed in it while it runs. */
final class ThoraxScene implements StabilityScene {
    /** How long a body has to come to rest, s. */
    static final double SETTLING_S = 20;

    /**
     * About critical, N s/m, for the springs that bring the paper's sheet home; its own 0.02 lets it swing for a
     * minute.
     */
    static final double SETTLING_DAMPING = 1;

    private final Simulation simulation;
    private final Consumer<Simulation> beforeStep;

    /** @param beforeStep what is done to the simulation before each step */
    ThoraxScene(Scenario scenario, Thorax thorax, Consumer<Simulation> beforeStep) {
        simulation = Simulation.of(scenario, thorax);
        this.beforeStep = beforeStep;
    }

    static <T> Assignment assignment(Setting<T> setting, T value) {
        return Assignment.of("slider " + setting.key(), setting, value);
    }

    @Override
    public Stepper stepper() {
        return simulation.stepper();
    }

    @Override
    public void step() {
        beforeStep.accept(simulation);
        simulation.step();
    }

    @Override
    public double linkError() {
        return simulation.linkError();
    }

    @Override
    public boolean undoLastChange() {
        return simulation.undoLastChange();
    }

    @Override
    public void stopBreathing() {
        List<Assignment> changes = new ArrayList<>(List.of(assignment(Breathing.DEPTH, 0.0)));
        if (simulation.start().material() == Materials.PAPER) {
            changes.add(assignment(TissueMass.DAMPING, SETTLING_DAMPING));
        }
        simulation.change(changes);
    }

    @Override
    public void close() {
        simulation.close();
    }
}
