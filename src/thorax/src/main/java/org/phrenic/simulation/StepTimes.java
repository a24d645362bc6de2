package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/** When the steps of a run are made; each change of the time step counts from its step on. */
public final class StepTimes {
    private final long steps;
    private final double totalS;
    private final List<Stretch> stretches = new ArrayList<>();

    /** Steps of one size from a step on, which is made at a time. */
    private record Stretch(long step, double timeS, double dt) {
        double timeOf(long later) {
            return timeS + (later - step) * dt;
        }
    }

    /** @param totalS time to cover, s, if the scenario states no number of steps */
    StepTimes(Scenario start, double totalS) {
        steps = start.steps();
        this.totalS = totalS;
        stretches.add(new Stretch(0, 0, start.timeStepS()));
    }

    /** Adds a change, which is not before those added. */
    void add(ScheduledChange change) {
        long step = change.step();
        if (change.assignment().setting() == Numerics.TIME_STEP && step < lastStep()) {
            double dt = (Double) change.assignment().value();
            stretches.add(new Stretch(step, last().timeOf(step), dt));
        }
    }

    /** Adds changes in the order of their steps. */
    StepTimes with(List<ScheduledChange> changes) {
        changes.forEach(this::add);
        return this;
    }

    private Stretch last() {
        return stretches.get(stretches.size() - 1);
    }

    /** Number of the last step. */
    long lastStep() {
        return steps >= 0 ? steps : last().step() + SimulationRun.stepsFor(totalS - last().timeS(), last().dt());
    }

    /** Time of the last step, s. It may lie beyond the duration that is asked for. */
    public double lastS() {
        return last().timeOf(lastStep());
    }

    /** Time of the first step that is no more than half a step before a time, s. */
    public double nearestS(double timeS) {
        Stretch stretch = stretches.get(0);
        for (Stretch later : stretches) {
            stretch = later.timeS() <= timeS ? later : stretch;
        }
        double into = Math.ceil((timeS - stretch.timeS()) / stretch.dt() - 0.5);
        return stretch.timeS() + Math.max(0, into) * stretch.dt();
    }
}
