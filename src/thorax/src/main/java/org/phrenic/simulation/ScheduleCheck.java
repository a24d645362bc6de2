package org.phrenic.simulation;

import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.LiveBreathing;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/** Refuses scheduled changes that come after the end of a run, which would do nothing. */
public final class ScheduleCheck {
    private ScheduleCheck() {}

    /**
     * Checks the changes of a scenario that runs to its end. A change of the time step moves the end.
     *
     * @throws BadInputException with one sentence, if a change is scheduled for a step after the last
     */
    public static void requireWithinRun(Scenario scenario) {
        if (scenario.changes().isEmpty()) {
            return;
        }
        double total = scenario.durationS(new LiveBreathing(scenario));
        Scenario now = scenario;
        double time = 0;
        long step = 0;
        long end = end(scenario, total, 0, 0);
        for (ScheduledChange change : scenario.changes()) {
            if (change.step() > end) {
                throw new BadInputException(change.assignment().origin() + ": found step " + change.step()
                        + " after the end of the run, expected at most step " + end + " (--steps, --duration)");
            }
            if (change.assignment().setting() == Numerics.TIME_STEP) {
                time += (change.step() - step) * now.timeStepS();
                step = change.step();
                now = now.with(Numerics.TIME_STEP, (Double) change.assignment().value());
                end = end(now, total, time, step);
            }
        }
    }

    private static long end(Scenario scenario, double total, double time, long step) {
        return scenario.steps() >= 0
                ? scenario.steps()
                : step + SimulationRun.stepsFor(total - time, scenario.timeStepS());
    }
}
