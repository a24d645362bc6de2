package org.phrenic.simulation;

import java.util.List;
import java.util.Optional;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.LiveBreathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/** Refuses, before a run, scheduled changes that would do nothing in it or would end it. */
public final class ScheduleCheck {
    private ScheduleCheck() {}

    /**
     * Checks the changes of a scenario that runs to its end.
     *
     * @throws BadInputException with one sentence that names the change, if one is scheduled for a step after the last
     *     or gives a breath that is impossible
     */
    public static void require(Scenario scenario) {
        requireWithinRun(scenario);
        requireBreathing(scenario);
    }

    /** A change of the time step moves the end. */
    private static void requireWithinRun(Scenario scenario) {
        if (scenario.changes().isEmpty()) {
            return;
        }
        StepTimes times = new StepTimes(scenario, scenario.durationS(new LiveBreathing(scenario)));
        for (ScheduledChange change : scenario.changes()) {
            if (change.step() > times.lastStep()) {
                throw new BadInputException(change.assignment().origin() + ": found step " + change.step()
                        + " after the end of the run, expected at most step " + times.lastStep()
                        + " (--steps, --duration)");
            }
            times.add(change);
        }
    }

    /** The changes of one step are made together, so that only the last of them must leave a breath. */
    private static void requireBreathing(Scenario scenario) {
        List<ScheduledChange> changes = scenario.changes();
        Scenario now = scenario.withChanges(List.of());
        Optional<Assignment> breath = Optional.empty();
        for (int i = 0; i < changes.size(); i++) {
            Assignment change = changes.get(i).assignment();
            now = now.changed(List.of(change));
            breath = change.setting().effect().isOfPattern() ? Optional.of(change) : breath;
            boolean lastOfStep = i + 1 == changes.size()
                    || changes.get(i + 1).step() != changes.get(i).step();
            if (lastOfStep && breath.isPresent()) {
                requireBreathing(now, breath.get());
                breath = Optional.empty();
            }
        }
    }

    private static void requireBreathing(Scenario now, Assignment change) {
        try {
            Breathing.patternOf(now);
        } catch (BadInputException e) {
            throw new BadInputException(change.origin() + ": " + e.getMessage(), e);
        }
    }
}
