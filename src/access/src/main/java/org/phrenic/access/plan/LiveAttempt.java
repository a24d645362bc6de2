package org.phrenic.access.plan;

import java.util.List;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleSnapshot;

/**
 * A finished attempt in a live run.
 *
 * @param steps as those of a plan: what was done by hand, or the played plan's
 * @param snapshots for pictures
 * @param endS simulated time at its end, s
 * @param stateHash of the body at its end
 */
public record LiveAttempt(
        List<PlanStep> steps,
        TargetLesion target,
        AttemptRecord record,
        List<NeedleSnapshot> snapshots,
        double endS,
        String stateHash) {
    /** The plan that repeats it. */
    public RehearsalPlan toPlan(RehearsalPlan original) {
        return original.withSteps(target, steps, endS);
    }
}
