package org.phrenic.access.plan;

import java.util.Optional;

/** One thing to do in a planned attempt. */
public sealed interface PlanStep {
    /** Where to read of it: file, line and key. */
    String place();

    /** Waits until something happens in the breathing. */
    record WaitFor(String place, BreathEvent event) implements PlanStep {}

    /** Waits. */
    record WaitSeconds(String place, double seconds) implements PlanStep {}

    /** Asks for the breath to be held where it is, or to go on. */
    record HoldBreath(String place, boolean held) implements PlanStep {}

    /**
     * Sets the needle on the skin.
     *
     * @param entryRest on the skin at end-expiration, LPS, mm; empty for the best point of the access map
     * @param atEndExpiration whether the best is that at end-expiration, not that over the whole breath
     */
    record Place(String place, Optional<double[]> entryRest, boolean atEndExpiration, Aim aim) implements PlanStep {}

    /** Points the needle elsewhere. */
    record Redirect(String place, Aim aim) implements PlanStep {}

    /**
     * Moves the tip until it is there.
     *
     * @param depthMm below the skin; empty for as deep as the needle was aimed
     * @param awaited whether the next step waits until it is there
     */
    record Advance(String place, Optional<Double> depthMm, double speedMmPerS, boolean awaited) implements PlanStep {}

    /** Takes a sample. */
    record Sample(String place) implements PlanStep {}

    /**
     * Where a needle is pointed.
     *
     * @param point in the room, LPS, mm; empty for the target
     * @param atRest whether the target is meant where it is at end-expiration, not where it is now
     */
    record Aim(Optional<double[]> point, boolean atRest) {}
}
