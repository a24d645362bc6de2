package org.phrenic.study.stability;

import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;

/** A thorax of the program, as it is run for anybody, and what is done to it on the way. */
final class ThoraxScene implements StabilityScene {
    /** Something done before each step. */
    interface Intervention {
        void beforeStep(Simulation simulation);
    }

    private final Simulation simulation;
    private final Intervention intervention;

    ThoraxScene(Scenario scenario, Thorax thorax, Intervention doing) {
        simulation = Simulation.of(scenario, thorax);
        this.intervention = doing;
    }

    @Override
    public Stepper stepper() {
        return simulation.stepper();
    }

    @Override
    public void step() {
        intervention.beforeStep(simulation);
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
        simulation.change(BreathStop.stopChanges(simulation.start()));
    }

    @Override
    public void close() {
        simulation.close();
    }
}
