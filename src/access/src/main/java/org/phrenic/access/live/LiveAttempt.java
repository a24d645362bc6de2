package org.phrenic.access.live;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.PlanStep;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;

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

    /**
     * The result that playing a plan without a window gives.
     *
     * @param done plan that the attempt followed, or the one made of it by {@link #toPlan}
     * @param planned body by which the planned path is judged over the breath
     */
    public Rehearsal toRehearsal(RehearsalPlan done, BodySurfaces body, TargetAccess access, MovingAnatomy planned) {
        Optional<PathOverBreath> path = Rehearsal.plannedPath(done, access, planned, record);
        return new Rehearsal(done, body, access, path, record, probe, snapshots, stateHash);
    }
}
