package org.phrenic.access.plan;

import java.util.List;
import java.util.Random;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Vectors;
import org.phrenic.simulation.observe.Frame;

/**
 * An operator with a known hand, for measuring how hard an exercise is. It sees the target with the latency of the
 * image, waits for the end of an expiration, places the needle a reaction time later where the access map has its best
 * entry, points it at where it sees the target, with normally distributed errors of the hand, advances it at once to
 * the depth that it sees, with such an error too, and takes the sample a reaction time after the needle has arrived. It
 * does not correct. The breath is a recorded one, repeated; in a held breath it stands still from 0.4 s after the end
 * of the expiration.
 */
public final class RobotOperator {
    private static final double FRAME_S = 0.05;
    private static final double SPEED_MM_PER_S = 50;
    private static final double PATIENT_REACTION_S = 0.4;
    private static final double GIVE_UP_S = 60;

    /**
     * The hand.
     *
     * @param reactionS reaction time, s
     * @param latencyS latency of the image, s
     * @param angleDeg standard deviation of each angle of the needle, degrees
     * @param depthMm standard deviation of the depth, mm
     */
    public record Hand(double reactionS, double latencyS, double angleDeg, double depthMm) {
        /** Reaction time 0.25 s, latency 0.1 s, 1.5 degrees, 2 mm. */
        public static final Hand STANDARD = new Hand(0.25, 0.1, 1.5, 2);
    }

    private final RehearsalPlan plan;
    private final MovingAnatomy anatomy;
    private final TargetAccess access;
    private final double[] entryRest;
    private final Hand hand;
    private final boolean held;
    private final List<BreathMoment> breath;
    private final double periodS;
    private final Frame frame;
    private double timeS;
    private double stoppedS;

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
        breath = access.map().cycle();
        frame = breath.get(0).frame().copy();
        int n = breath.size();
        periodS = n > 1 ? (breath.get(1).timeS() - breath.get(0).timeS()) * n : FRAME_S;
    }

    /** Makes an attempt; the same seed gives the same. */
    public AttemptRecord attempt(long seed) {
        Random random = new Random(seed);
        double start = random.nextDouble() * periodS;
        timeS = 0;
        stoppedS = Double.POSITIVE_INFINITY;
        NeedleInsertion needle = new NeedleInsertion(anatomy, access.target(), plan.needle(), plan.avoided());
        next(needle, start);
        double seenS = untilSeen(needle, start);
        stoppedS = held ? seenS + PATIENT_REACTION_S : stoppedS;
        double actS = seenS + hand.reactionS() + (held ? PATIENT_REACTION_S : 0);
        double[] target = needle.targetNow();
        while (timeS < actS) {
            if (timeS <= actS - hand.latencyS()) {
                target = needle.targetNow();
            }
            next(needle, start);
        }
        insert(needle, target, random);
        double arrivedS = timeS;
        while (timeS < arrivedS + hand.reactionS() || needle.isMoving()) {
            arrivedS = needle.isMoving() ? timeS : arrivedS;
            next(needle, start);
        }
        needle.sample();
        return needle.record();
    }

    private void insert(NeedleInsertion needle, double[] target, Random random) {
        needle.placeAtRest(entryRest, target);
        double depth = Vectors.distance(needle.shaft().entry(), target) + hand.depthMm() * random.nextGaussian();
        double axial = hand.angleDeg() * random.nextGaussian();
        double cranial = hand.angleDeg() * random.nextGaussian();
        needle.turn(NeedleAngles.of(needle.shaft().direction()).turned(axial, cranial));
        needle.advance(Math.max(1, Math.min(plan.needle().lengthMm(), depth)), SPEED_MM_PER_S);
    }

    /** Waits until the image shows the pause after an expiration that has been seen to begin. */
    private double untilSeen(NeedleInsertion needle, double start) {
        boolean breathed = false;
        while (timeS < GIVE_UP_S) {
            RespiratoryPhase seen = moment(start + timeS - hand.latencyS()).label();
            boolean still = seen == RespiratoryPhase.PAUSE || seen == RespiratoryPhase.HOLD;
            if (still && breathed) {
                break;
            }
            breathed |= !still;
            next(needle, start);
        }
        return timeS;
    }

    private void next(NeedleInsertion needle, double start) {
        BreathMoment now = moment(start + Math.min(timeS, stoppedS));
        frame.copyFrom(now.frame());
        frame.setState(frame.serial() + 1, frame.step(), timeS, now.frame().values());
        needle.update(frame, timeS > stoppedS ? RespiratoryPhase.HOLD : now.label());
        timeS += FRAME_S;
    }

    /** The recorded moment of the repeated breath at or before a time. */
    private BreathMoment moment(double atS) {
        double into = atS % periodS;
        double share = (into < 0 ? into + periodS : into) / periodS;
        return breath.get(Math.min(breath.size() - 1, (int) (share * breath.size())));
    }
}
