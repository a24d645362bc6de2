package org.phrenic.simulation.live;

import java.util.Optional;
import org.phrenic.simulation.SubstepReason;

/**
 * How a run stands.
 *
 * @param step steps since the start
 * @param timeS simulated time, s
 * @param dtS time step, s
 * @param substeps parts into which each step is split
 * @param stepsPerS steps a second of wall time, while it runs; 0 while it does not
 * @param realtimeFactor simulated over wall time
 * @param playing whether it runs
 * @param substepReason why steps are split; empty if the step is within the stability limit
 * @param phaseLabel what the breath is doing: inspiration, expiration, pause, hold; empty before the first scene
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
        String phaseLabel) {
    /** Before the first scene. */
    public static final RunStatus NOTHING = new RunStatus(0, 0, 0, 1, 0, 0, false, Optional.empty(), "");

    /** Why steps are split, in one sentence; empty if they are not. */
    public String stabilityMessage() {
        return substepReason.map(SubstepReason::message).orElse("");
    }
}
