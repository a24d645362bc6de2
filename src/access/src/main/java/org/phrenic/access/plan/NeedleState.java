package org.phrenic.access.plan;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * How a rehearsal stands at one look, for a screen. Arrays are not to be written to.
 *
 * @param timeS simulated time, s
 * @param breath its number, from 1
 * @param label what the breath does
 * @param target its middle, LPS, mm
 * @param targetRadiusMm its radius
 * @param entry where the needle goes in or is meant to; empty while that is not chosen
 * @param placed whether the needle is on or in the body
 * @param hub of the needle, LPS, mm; where it would be while it is not placed
 * @param tip as above
 * @param depthMm of the tip below the skin
 * @param aimedDepthMm how deep the target lies along the needle, or from the entry while it is not placed
 * @param inLiver whether the tip is in the liver
 * @param moving whether it is being moved
 * @param targetingError how the tip lies to the target; empty while it is not placed
 * @param path what the way from the skin to the target meets now, or to the aimed depth once it is placed; empty
 *     without an entry
 * @param reasons why that way should not be taken now, in words; empty if it is free
 * @param marginMm distance of the way from what is to be avoided; 0 where it is not free
 * @param nearest what that is taken from; empty for nothing near
 * @param warnings what is wrong with the needle as it is in the body, in words
 * @param samples taken so far
 * @param pendingHold what a hold that was asked for waits for, in words; empty for none
 * @param playback whether a plan is being played
 */
public record NeedleState(
        double timeS,
        int breath,
        RespiratoryPhase label,
        double[] target,
        double targetRadiusMm,
        Optional<double[]> entry,
        boolean placed,
        double[] hub,
        double[] tip,
        double depthMm,
        double aimedDepthMm,
        boolean inLiver,
        boolean moving,
        Optional<TargetingError> targetingError,
        Optional<PathAnalysis> path,
        List<String> reasons,
        double marginMm,
        String nearest,
        List<String> warnings,
        int samples,
        String pendingHold,
        boolean playback) {
    /** Whether there is a needle to draw. */
    public boolean hasNeedle() {
        return entry.isPresent();
    }
}
