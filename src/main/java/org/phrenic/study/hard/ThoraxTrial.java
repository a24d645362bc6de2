package org.phrenic.study.hard;

import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;

/** A thorax of the program, as it is run for anybody, and what is done to it on the way. */
final class ThoraxTrial implements Trial {
    /** Something done before each step. */
    interface Doing {
        void before(Simulation simulation);
    }

    private final Simulation simulation;
    private final Doing doing;

    ThoraxTrial(Scenario scenario, Thorax thorax, Doing doing) {
        simulation = Simulation.of(scenario, thorax);
        this.doing = doing;
    }

    @Override
    public Stepper stepper() {
        return simulation.stepper();
    }

    @Override
    public void step() {
        doing.before(simulation);
        simulation.step();
    }

    @Override
    public double linkError() {
        return simulation.linkError();
    }

    @Override
    public boolean takeBack() {
        return simulation.undoLastChange();
    }

    @Override
    public void calm() {
        simulation.change(Calm.stop(simulation.start()));
    }

    @Override
    public void close() {
        simulation.close();
    }
}
