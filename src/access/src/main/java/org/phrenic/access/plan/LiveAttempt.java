package org.phrenic.access.plan;

import java.util.List;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.attempt.ProbeUse;

/**
 * A finished attempt in a live run.
 *
 * @param steps steps of the attempt: recorded manual actions, or the steps of the played plan
 * @param probe how the ultrasound probe was used
 * @param snapshots snapshots for pictures
 * @param endS simulated time at the end, s
 * @param stateHash hash of the body state at the end
 */
public record LiveAttempt(
        List<PlanStep> steps,
        TargetLesion target,
        AttemptRecord record,
        ProbeUse probe,
        List<NeedleSnapshot> snapshots,
        double endS,
        String stateHash) {
    public RehearsalPlan toPlan(RehearsalPlan original) {
        return original.withSteps(target, steps, endS);
    }
}
