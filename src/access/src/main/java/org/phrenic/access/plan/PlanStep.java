package org.phrenic.access.plan;

import java.util.Optional;
import org.phrenic.access.attempt.NeedleAngles;

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
     * @param back whether the step may only take the needle back
     */
    record Advance(String place, Optional<Double> depthMm, double speedMmPerS, boolean awaited, boolean back)
            implements PlanStep {
        /** A move in either direction. */
        public Advance(String place, Optional<Double> depthMm, double speedMmPerS, boolean awaited) {
            this(place, depthMm, speedMmPerS, awaited, false);
        }
    }

    /** Takes a sample. */
    record Sample(String place) implements PlanStep {}

    /**
     * Puts the ultrasound probe on the skin, moves it, or lifts it.
     *
     * @param hold how it is held from here on; empty if it is lifted
     */
    record Probe(String place, Optional<ProbeHold> hold) implements PlanStep {}

    /** Takes an ultrasound image. */
    record Image(String place, ProbeHold probe) implements PlanStep {}

    /**
     * Where a needle is pointed: at a position, or at angles as by a hand.
     *
     * @param point fixed position, LPS, mm; empty for the target
     * @param atRest whether to use the position of the target at end-expiration instead of its current position
     * @param angles angles of the needle; empty if it is pointed at a position
     * @param afterProgram whether a hand turned the needle to the angles from where the program had pointed it
     */
    record Aim(Optional<double[]> point, boolean atRest, Optional<NeedleAngles> angles, boolean afterProgram) {
        /** The current position of the target. */
        public static final Aim TARGET = new Aim(Optional.empty(), false, Optional.empty(), false);

        /** The target at end-expiration. */
        public static final Aim TARGET_AT_REST = new Aim(Optional.empty(), true, Optional.empty(), false);

        static Aim at(double[] point) {
            return new Aim(Optional.of(point), false, Optional.empty(), false);
        }

        public static Aim at(NeedleAngles angles) {
            return at(angles, false);
        }

        /** @param afterProgram whether the program had pointed the needle before a hand turned it on */
        public static Aim at(NeedleAngles angles, boolean afterProgram) {
            return new Aim(Optional.empty(), false, Optional.of(angles), afterProgram);
        }

        /** Whether it is a position that does not move with the breath. */
        boolean standsStill() {
            return point.isPresent() || atRest;
        }

        /** Whether the program points the needle, or did before a hand turned it on. */
        boolean byProgram() {
            return angles.isEmpty() || afterProgram;
        }
    }
}
