package org.phrenic.access.plan;

import java.util.List;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleSnapshot;

/**
 * An attempt on a run that is played live, as it ended.
 *
 * @param steps what was done, as a plan's; those of the plan where one was played
 * @param target it was about
 * @param record of it
 * @param snapshots what to make pictures of
 * @param endS simulated time at its end, s
 * @param stateHash of the body then
 */
public record LiveAttempt(
        List<PlanStep> steps,
        TargetLesion target,
        AttemptRecord record,
        List<NeedleSnapshot> snapshots,
        double endS,
        String stateHash) {
    /** The plan that does the same again. */
    public RehearsalPlan toPlan(RehearsalPlan asked) {
        return asked.withSteps(target, steps, endS);
    }
}
