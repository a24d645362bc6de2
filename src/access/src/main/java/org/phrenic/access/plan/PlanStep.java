package org.phrenic.access.plan;

import java.util.Optional;

/** One step of a planned attempt. */
public sealed interface PlanStep {
    /** Location of the step for error messages: file, step and key. */
    String place();

    /** Waits for a breathing event. */
    record WaitFor(String place, BreathEvent event) implements PlanStep {}

    /** Waits for a duration, s. */
    record WaitSeconds(String place, double seconds) implements PlanStep {}

    /** Holds or releases the breath. */
    record HoldBreath(String place, boolean held) implements PlanStep {}

    /**
     * Places the needle on the skin.
     *
     * @param entryRest entry point on the skin at end-expiration, LPS, mm; empty for the best point of the access map
     * @param atEndExpiration whether the best point is chosen for end-expiration instead of the whole breath
     */
    record Place(String place, Optional<double[]> entryRest, boolean atEndExpiration, Aim aim) implements PlanStep {}

    /** Points the needle at another position. */
    record Redirect(String place, Aim aim) implements PlanStep {}

    /**
     * Moves the tip to a depth.
     *
     * @param depthMm depth below the skin, mm; empty for the depth of the aim
     * @param awaited whether the next step waits until the tip has arrived
     */
    record Advance(String place, Optional<Double> depthMm, double speedMmPerS, boolean awaited) implements PlanStep {}

    /** Takes a sample. */
    record Sample(String place) implements PlanStep {}

    /** Takes an ultrasound image. */
    record Image(String place, ProbeHold probe) implements PlanStep {}

    /**
     * The position that a needle is pointed at.
     *
     * @param point fixed position, LPS, mm; empty for the target
     * @param atRest whether to use the position of the target at end-expiration instead of its current position
     */
    record Aim(Optional<double[]> point, boolean atRest) {
        /** The current position of the target. */
        static final Aim TARGET = new Aim(Optional.empty(), false);

        /** The target at end-expiration. */
        static final Aim TARGET_AT_REST = new Aim(Optional.empty(), true);
    }
}
