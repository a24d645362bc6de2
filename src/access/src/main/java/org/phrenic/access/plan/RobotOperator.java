package org.phrenic.access.plan;

import java.util.Random;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.SeededRandom;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.Vectors;

/**
 * An operator with a known hand, for measuring how hard an exercise is. It sees the body with the latency of the image
 * and acts a reaction time later. At an end of expiration it places the needle on the skin and points it at where it
 * sees the target, with normally distributed errors of the hand; it advances the needle until its sample would be taken
 * at the depth that it sees, with such an error too, and takes it a reaction time after the needle has arrived. While
 * the body breathes it is gated: it advances while it sees the target within {@value #GATE_MM} mm of its place at
 * end-expiration, and stops when it no longer does. In a held breath it advances without a stop; the patient holds the
 * breath 0.4 s after the image shows the target within that distance in expiration. It does not correct the direction.
 * The breath is a {@link RepeatedBreath}.
 */
public final class RobotOperator {
    private static final double FRAME_S = 0.05;
    private static final double SPEED_MM_PER_S = 50;
    private static final double PATIENT_REACTION_S = 0.4;
    /** Distance of the target from its place at end-expiration at which the gate closes, mm; chosen. */
    private static final double GATE_MM = 3;

    private static final double GIVE_UP_S = 120;

    /**
     * The hand, and what moves besides the breath.
     *
     * @param reactionS reaction time, s
     * @param latencyS latency of the image, s
     * @param angleDeg standard deviation of the needle in each of two directions at a right angle to it, degrees
     * @param depthMm standard deviation of the depth, mm
     * @param levelMm standard deviation of the level at end-expiration from breath to breath, mm
     * @param beatMm amplitude of the heartbeat, mm
     * @param driftMmPerS drift toward the head in a held breath, mm/s
     */
    public record Hand(
            double reactionS,
            double latencyS,
            double angleDeg,
            double depthMm,
            double levelMm,
            double beatMm,
            double driftMmPerS) {
        /**
         * Reaction time 0.25 s, latency 0.1 s. Angle: 3.4 degrees on average freehand (PMC4499536), the mean of a
         * Rayleigh distribution of 2.7 degrees. Depth: 2.2 mm, from errors of 4.2 mm beside and 4.6 to 4.9 mm in all of
         * freehand punctures (doi 10.1002/rcs.1505). Level: 1.5 mm (doi 10.1186/1748-717X-2-32, liver, gated at
         * end-expiration). Heartbeat: half of 1.4 mm, the mean over 21 people of the diaphragm's greatest motion in a
         * held breath (PMID 16458774). Drift: 5.6 mm in 24 s, the most in 15 people (PMC7055431).
         */
        public static final Hand STANDARD = new Hand(0.25, 0.1, 2.7, 2.2, 1.5, 0.7, 0.23);

        private static final double BEAT_HZ = 1.1;

        private RepeatedBreath.Unsteadiness unsteadiness() {
            return new RepeatedBreath.Unsteadiness(levelMm, beatMm, BEAT_HZ, driftMmPerS);
        }
    }

    private final RehearsalPlan plan;
    private final MovingAnatomy anatomy;
    private final TargetAccess access;
    private final double[] entryRest;
    private final Hand hand;
    private final boolean held;
    private final RepeatedBreath breath;
    private double timeS;

    /**
     * @param access target and recorded breath
     * @param entryRest entry on the skin at end-expiration, LPS, mm
     * @param held whether the breath is held for the insertion
     */
    public RobotOperator(
            RehearsalPlan plan,
            MovingAnatomy anatomy,
            TargetAccess access,
            double[] entryRest,
            Hand hand,
            boolean held) {
        this.plan = plan;
        this.anatomy = anatomy;
        this.access = access;
        this.entryRest = entryRest;
        this.hand = hand;
        this.held = held;
        breath = new RepeatedBreath(anatomy, access.map(), hand.unsteadiness());
    }

    /**
     * Makes an attempt; the same seed gives the same. The errors of the hand are the same in free and held breath.
     *
     * @throws BadInputException if the needle does not arrive in the time of an attempt
     */
    public AttemptRecord attempt(long seed) {
        Random random = SeededRandom.of(seed);
        timeS = 0;
        breath.begin(random.nextLong());
        NeedleInsertion needle = new NeedleInsertion(anatomy, access.target(), plan.needle(), plan.avoided());
        untilSeen();
        if (held) {
            breath.holdFrom(timeS + PATIENT_REACTION_S);
        }
        timeS += hand.reactionS() + (held ? PATIENT_REACTION_S : 0) - hand.latencyS();
        look(needle);
        double[] target = needle.targetNow();
        timeS += hand.latencyS();
        look(needle);
        insert(needle, target, random);
        timeS += hand.reactionS();
        look(needle);
        needle.sample();
        return needle.record();
    }

    /** Time since the beginning of the present attempt, or of the last one to its end, s. */
    double timeS() {
        return timeS;
    }

    private void insert(NeedleInsertion needle, double[] target, Random random) {
        needle.placeAtRest(entryRest, target);
        double depth = Vectors.distance(needle.shaft().entry(), target) + hand.depthMm() * random.nextGaussian();
        double level = hand.angleDeg() * random.nextGaussian();
        double head = hand.angleDeg() * random.nextGaussian();
        needle.turn(NeedleAngles.of(needle.shaft().direction()).tilted(level, head));
        double goal = Math.max(
                1, Math.min(plan.needle().lengthMm(), depth - plan.needle().coreMm() / 2));
        needle.advance(goal, SPEED_MM_PER_S);
        while (needle.isMoving()) {
            nextImage();
            look(needle);
            double acts = timeS - hand.latencyS() - hand.reactionS();
            if (!held && needle.isMoving() && !isOpenAt(acts)) {
                needle.advance(needle.shaft().depth(), SPEED_MM_PER_S);
                while (!isOpenAt(timeS - hand.latencyS() - hand.reactionS())) {
                    nextImage();
                }
                look(needle);
                needle.advance(goal, SPEED_MM_PER_S);
            }
        }
    }

    /**
     * Waits until the image shows the target come back to its place at end-expiration; for a breath where it does not
     * leave it.
     */
    private void untilSeen() {
        while (isOpenAt(timeS - hand.latencyS()) && timeS < breath.periodS()) {
            nextImage();
        }
        while (!isOpenAt(timeS - hand.latencyS())) {
            nextImage();
        }
    }

    private void nextImage() {
        timeS += FRAME_S;
        if (timeS >= GIVE_UP_S) {
            throw new BadInputException(Numbers.format(
                    "%s: found a needle that does not arrive in %.0f s, expected a target that is longer near its place"
                            + " at end-expiration",
                    plan.file(), GIVE_UP_S));
        }
    }

    /** Whether the target is near its place at end-expiration. */
    private boolean isOpenAt(double atS) {
        return Math.abs(breath.awayMm(atS)) <= GATE_MM;
    }

    private void look(NeedleInsertion needle) {
        needle.update(breath.at(timeS), breath.label(timeS));
    }
}
