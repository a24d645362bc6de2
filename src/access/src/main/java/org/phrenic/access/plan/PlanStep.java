package org.phrenic.access.plan;

import java.util.Optional;

/** One step of a planned attempt. */
public sealed interface PlanStep {
    /** Where the step is given, for messages: file, step and key. */
    String place();

    /** Waits for an event of the breathing. */
    record WaitFor(String place, BreathEvent event) implements PlanStep {}

    /** Waits for a time. */
    record WaitSeconds(String place, double seconds) implements PlanStep {}

    /** Holds or releases the breath. */
    record HoldBreath(String place, boolean held) implements PlanStep {}

    /**
     * Sets the needle on the skin.
     *
     * @param entryRest on the skin at end-expiration, LPS, mm; empty for the best point of the access map
     * @param atEndExpiration whether the best point is that at end-expiration, not over the whole breath
     */
    record Place(String place, Optional<double[]> entryRest, boolean atEndExpiration, Aim aim) implements PlanStep {}

    /** Points the needle elsewhere. */
    record Redirect(String place, Aim aim) implements PlanStep {}

    /**
     * Moves the tip to a depth.
     *
     * @param depthMm below the skin; empty for the depth of the aim
     * @param awaited whether the next step waits until the tip is there
     */
    record Advance(String place, Optional<Double> depthMm, double speedMmPerS, boolean awaited) implements PlanStep {}

    /** Takes a sample. */
    record Sample(String place) implements PlanStep {}

    /**
     * Where a needle is pointed.
     *
     * @param point in space, LPS, mm; empty for the target
     * @param atRest whether the target is meant at its position at end-expiration, not its current one
     */
    record Aim(Optional<double[]> point, boolean atRest) {
        /** The current position of the target. */
        static final Aim TARGET = new Aim(Optional.empty(), false);

        /** The target at end-expiration. */
        static final Aim TARGET_AT_REST = new Aim(Optional.empty(), true);
    }
}
