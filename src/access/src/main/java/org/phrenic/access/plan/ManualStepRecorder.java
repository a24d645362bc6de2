package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What was done by hand, written down as the steps of a plan: played from the start of the same run, the plan does the
 * same at the same looks.
 */
final class ManualStepRecorder {
    private static final PlanStep.Aim AT_TARGET = new PlanStep.Aim(Optional.empty(), false);

    private record At(double timeS, PlanStep step) {}

    private final List<At> done = new ArrayList<>();

    void held(double timeS, boolean held) {
        done.add(new At(timeS, new PlanStep.HoldBreath("by hand, hold_breath", held)));
    }

    void placed(double timeS, double[] entryRest) {
        done.add(new At(timeS, new PlanStep.Place("by hand, place", Optional.of(entryRest), false, AT_TARGET)));
    }

    void redirected(double timeS) {
        done.add(new At(timeS, new PlanStep.Redirect("by hand, redirect", AT_TARGET)));
    }

    void moved(double timeS, double toDepthMm, double speedMmPerS) {
        done.add(new At(timeS, new PlanStep.Advance("by hand, advance", Optional.of(toDepthMm), speedMmPerS, false)));
    }

    void sampled(double timeS) {
        done.add(new At(timeS, new PlanStep.Sample("by hand, sample")));
    }

    /** Another attempt begins: what was done with the needle has left no trace in the body, but a held breath has. */
    void keepBreathHolds() {
        done.removeIf(at -> !(at.step() instanceof PlanStep.HoldBreath));
    }

    /** The run is at its start again. */
    void clear() {
        done.clear();
    }

    /** All from the start of the run to a time, with the waits between. */
    List<PlanStep> stepsUntil(double timeS) {
        List<PlanStep> steps = new ArrayList<>();
        double now = 0;
        for (At at : done) {
            waitFor(at.timeS() - now, steps);
            steps.add(at.step());
            now = at.timeS();
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
