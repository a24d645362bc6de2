package org.phrenic.access.live;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.access.plan.PlanStep;

/** Records manual actions as steps of a plan that reproduces them frame by frame from the start of the run. */
final class ManualStepRecorder {
    private record Timed(double timeS, PlanStep step) {}

    private final List<Timed> done = new ArrayList<>();

    void add(double timeS, PlanStep step) {
        done.add(new Timed(timeS, step));
    }

    /**
     * Discards all steps except breath holds before another attempt. A withdrawn needle does not affect the body; holds
     * do.
     */
    void keepBreathHolds() {
        done.removeIf(timed -> !(timed.step() instanceof PlanStep.HoldBreath));
    }

    /** Clears the recording after the run has restarted. */
    void clear() {
        done.clear();
    }

    /** All steps from the start of the run until a time, including the waits between them. */
    List<PlanStep> stepsUntil(double timeS) {
        List<PlanStep> steps = new ArrayList<>();
        double now = 0;
        for (Timed timed : done) {
            waitFor(timed.timeS - now, steps);
            steps.add(timed.step);
            now = timed.timeS;
        }
        waitFor(timeS - now, steps);
        return steps;
    }

    private static void waitFor(double seconds, List<PlanStep> steps) {
        if (seconds > 0) {
            steps.add(new PlanStep.WaitSeconds("by hand, wait", seconds));
        }
    }
}
