package org.phrenic.rehearsal;

import java.util.List;

/**
 * An attempt on a run that is played live, as it ended.
 *
 * @param steps what was done, as a plan's; those of the plan where one was played
 * @param target it was about
 * @param record of it
 * @param views what to make pictures of
 * @param endS simulated time at its end, s
 * @param stateHash of the body then
 */
public record LiveAttempt(
        List<PlanStep> steps,
        Target target,
        AttemptRecord record,
        List<NeedleView> views,
        double endS,
        String stateHash) {
    /** The plan that does the same again. */
    public RehearsalPlan planned(RehearsalPlan asked) {
        return asked.done(target, steps, endS);
    }
}
