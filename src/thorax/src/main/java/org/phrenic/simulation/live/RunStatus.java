package org.phrenic.simulation.live;

import java.util.Optional;
import org.phrenic.simulation.SubstepReason;

/**
 * Status of a run.
 *
 * @param step steps since the start
 * @param timeS simulated time, s
 * @param dtS time step, s
 * @param substeps number of substeps per step
 * @param stepsPerS steps per second of wall time; 0 while paused
 * @param realtimeFactor simulated over wall time
 * @param playing whether it is playing
 * @param substepReason why steps are split; empty if the step is within the stability limit
 * @param phaseLabel respiratory phase: inspiration, expiration, pause, hold; empty before the first scene
 * @param repeating whether steps repeat the record of a breath
 */
public record RunStatus(
        long step,
        double timeS,
        double dtS,
        int substeps,
        double stepsPerS,
        double realtimeFactor,
        boolean playing,
        Optional<SubstepReason> substepReason,
        String phaseLabel,
        boolean repeating) {
    /** Status before the first scene. */
    public static final RunStatus NOTHING = new RunStatus(0, 0, 0, 1, 0, 0, false, Optional.empty(), "", false);

    /** Reason for substeps in one sentence; empty without substeps. */
    public String stabilityMessage() {
        return substepReason.map(SubstepReason::message).orElse("");
    }
}
