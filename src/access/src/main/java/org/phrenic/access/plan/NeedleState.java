package org.phrenic.access.plan;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * State of a live rehearsal at one frame, for display. Positions LPS, mm; arrays are read-only.
 *
 * @param breath number of the breath, from 1
 * @param target centre of the target
 * @param entry of the needle, or the chosen one; empty while none is chosen
 * @param placed whether the needle is on or in the body
 * @param hub of the needle; of the planned one while it is not placed
 * @param tip of the needle; of the planned one while it is not placed
 * @param depthMm of the tip below the skin
 * @param aimedDepthMm depth of the target along the needle, or from the entry while it is not placed
 * @param targetingError empty while the needle is not placed
 * @param path from the skin to the target, or to the aimed depth of a placed needle; empty without an entry
 * @param reasons against that path, in words; empty if it is free
 * @param marginMm of the path to the avoided zones; 0 where it is not free
 * @param nearest label of the structure from which the margin is taken; empty for none
 * @param warnings on the needle in the body, in words
 * @param samples taken so far
 * @param pendingHold the event for which a requested hold waits, in words; empty for none
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
