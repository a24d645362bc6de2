package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.List;

/** Records what is done by hand as the steps of a plan that repeats it from the start of the run, frame by frame. */
final class ManualStepRecorder {
    private record Timed(double timeS, PlanStep step) {}

    private final List<Timed> done = new ArrayList<>();

    void add(double timeS, PlanStep step) {
        done.add(new Timed(timeS, step));
    }

    /** Keeps the breath holds for another attempt: a withdrawn needle leaves no trace in the body, but they do. */
    void keepBreathHolds() {
        done.removeIf(timed -> !(timed.step() instanceof PlanStep.HoldBreath));
    }

    /** The run is at its start again. */
    void clear() {
        done.clear();
    }

    /** All steps from the start of the run to a time, with the waits between them. */
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
