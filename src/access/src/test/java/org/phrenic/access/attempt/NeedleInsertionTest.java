package org.phrenic.access.attempt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;

/** Attempts in a body of boxes whose liver goes up and down by a known amount. */
class NeedleInsertionTest {
    private static final double TOLERANCE_MM = 1e-3;
    private static final double AMPLITUDE_MM = 12;
    private static final double PERIOD_S = 4;
    private static final double FRAME_S = 0.02;
    /** Through the whole path within one frame. */
    private static final double AT_ONCE = 1e6;

    private final BoxAnatomy body = new BoxAnatomy();
    private final MovingAnatomy scene = new MovingAnatomy(body.surfaces);
    private int frames;
    private double[] ribShift = new double[3];

    /** The liver is A (1 - cos) / 2 lower than at rest. */
    private static double down(double timeS) {
        return 0.5 * AMPLITUDE_MM * (1 - StrictMath.cos(2 * Math.PI * timeS / PERIOD_S));
    }

    private NeedleInsertion session(double diameterMm) {
        return session(diameterMm, Needle.standard());
    }

    private NeedleInsertion session(double diameterMm, Needle needle) {
        scene.update(body.still(0));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, 0}, diameterMm);
        NeedleInsertion session = new NeedleInsertion(scene, target, needle, NoGoZone.defaults());
        frames = -1;
        next(session);
        return session;
    }

    private void next(NeedleInsertion session) {
        frames++;
        double t = frames * FRAME_S;
        session.update(
                body.frame(t, t / PERIOD_S % 1, new double[] {0, 0, -down(t)}, -100, ribShift),
                RespiratoryPhase.INSPIRATION);
    }

    private void until(NeedleInsertion session, double timeS) {
        while ((frames + 0.5) * FRAME_S < timeS) {
            next(session);
        }
    }

    @Test
    void firedAtAKnownPhaseTheErrorIsTheMotionSinceItWasAimed() {
        for (double fired : new double[] {0, 0.5, 1, 1.5, 2, 3}) {
            NeedleInsertion session = session(20);
            double[] aim = session.targetNow();
            session.place(new double[] {0, 0, 0}, aim);
            until(session, fired);
            session.advance(90, AT_ONCE);
            next(session);
            double miss = down(frames * FRAME_S);
            TargetingError seen = session.sample();
            assertThat(seen.lateralMm()).isCloseTo(miss, within(TOLERANCE_MM));
            assertThat(seen.axialMm()).isCloseTo(0, within(TOLERANCE_MM));
            assertThat(seen.hit()).isEqualTo(miss <= 10);
            assertThat(session.record().hit()).isEqualTo(miss <= 10);
        }
    }

    /** On the skin it would keep its place, and the entry that is chosen next would not be where it goes in. */
    @Test
    void aNeedleThatIsTakenOutBeforeItIsInIsNotOnTheSkinAnyMore() {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 0}, session.targetNow());
        session.advance(30, AT_ONCE);
        session.advance(0, AT_ONCE);
        next(session);
        assertThat(session.shaft().isPlaced()).isFalse();
        assertThat(session.record().count(AttemptEvent.Kind.SKIN_PUNCTURE)).isZero();
    }

    /**
     * The capsule lies in a depth of 40 mm and is pushed by 3.5 mm before it is cut; the target begins in one of 38 mm.
     */
    @Test
    void aTipThatPushesTheCapsuleIntoTheTargetIsNoHit() {
        for (double depth : new double[] {39, 42, 45}) {
            scene.update(body.still(0));
            TargetLesion target = TargetLesion.at(scene, new double[] {48, 0, 0}, 20);
            NeedleInsertion session = new NeedleInsertion(scene, target, Needle.standard(), NoGoZone.defaults());
            session.update(body.still(0), RespiratoryPhase.PAUSE);
            session.place(new double[] {0, 0, 0}, session.targetNow());
            session.advance(depth, AT_ONCE);
            session.update(body.still(FRAME_S), RespiratoryPhase.PAUSE);
            assertThat(session.shaft().depth()).isEqualTo(depth);
            assertThat(session.sample().hit())
                    .as("at a depth of " + depth + " mm")
                    .isEqualTo(depth == 45);
        }
    }

    /** 6 mm beside the middle of a ball of 20 mm, the line is within it from 8 mm before to 8 mm behind the middle. */
    @Test
    void aCoreCountsByItsLengthInTheTarget() {
        for (double tip : new double[] {60, 77, 85, 95, 99}) {
            NeedleInsertion session = session(20, new Needle(18, 150, 20));
            session.place(new double[] {0, 0, 6}, new double[] {90, 0, 6});
            session.advance(tip, AT_ONCE);
            next(session);
            double off = 6 + down(frames * FRAME_S);
            double half = Math.sqrt(100 - off * off);
            double expected = Math.max(0, Math.min(tip + 20, 90 + half) - Math.max(tip, 90 - half));
            TargetingError sample = session.sample();
            assertThat(sample.coreInTargetMm().orElseThrow()).isCloseTo(expected, within(TOLERANCE_MM));
            assertThat(sample.axialMm()).as("from the middle of the core").isCloseTo(80 - tip, within(TOLERANCE_MM));
            assertThat(sample.hit()).isEqualTo(expected > 0);
        }
    }

    /** The tip stops before the lung, which lies from 20 to 30 mm; the core is thrown through it. */
    @Test
    void aCoreThrownIntoALungIsToldThoughTheNeedleItselfIsNot() {
        NeedleInsertion session = session(20, new Needle(18, 150, 20));
        session.place(new double[] {0, 0, 115}, new double[] {90, 0, 115});
        session.advance(15, AT_ONCE);
        next(session);
        next(session);
        assertThat(session.record().secondsIn()).doesNotContainKey(NoGoZone.LUNG);
        assertThat(session.record().zones().byCore()).isEmpty();
        session.sample();
        AttemptRecord record = session.record();
        assertThat(record.zones().byCore()).containsExactly(NoGoZone.LUNG);
        assertThat(record.isCoreInNoGo()).isTrue();
        assertThat(record.inNoGoS()).as("the throw takes no time").isZero();
        AttemptEvent thrown = record.first(AttemptEvent.Kind.CORE_ENTERS).orElseThrow();
        assertThat(thrown.structure()).isEqualTo("right lung");
        assertThat(thrown.depthMm()).isCloseTo(20, within(TOLERANCE_MM));
        assertThat(record.toMap()).containsEntry("touched_by_core", List.of("lung"));
    }

    /** The rib begins at 10 mm, the target at 80. */
    @Test
    void boneEndsACore() {
        NeedleInsertion session = session(20, new Needle(18, 150, 20));
        session.place(new double[] {0, 0, 35}, new double[] {90, 0, 35});
        session.advance(4, AT_ONCE);
        next(session);
        assertThat(session.record().count(AttemptEvent.Kind.BONE_CONTACT)).isZero();
        TargetingError sample = session.sample();
        AttemptRecord record = session.record();
        AttemptEvent contact = record.first(AttemptEvent.Kind.BONE_CONTACT).orElseThrow();
        assertThat(contact.depthMm()).isCloseTo(10, within(TOLERANCE_MM));
        assertThat(record.zones().byCore()).contains(NoGoZone.BONE);
        assertThat(record.count(AttemptEvent.Kind.CORE_ENTERS))
                .as("nothing is behind the bone")
                .isZero();
        assertThat(sample.coreMm()).isCloseTo(6, within(TOLERANCE_MM));
        assertThat(sample.toMap()).containsEntry("core_mm", sample.coreMm());
        assertThat(sample.axialMm()).as("from the middle of a core of 6 mm").isCloseTo(90 - 7, within(TOLERANCE_MM));
        assertThat(session.shaft().depth()).as("the tip").isEqualTo(4);
    }

    /** Turns by hand before the puncture are no redirection, several in the skin are one. */
    @Test
    void turnsByHandBetweenTwoMovementsAreOneRedirection() {
        NeedleInsertion session = session(20);
        session.placeAtRest(new double[] {0, 0, 0}, new NeedleAngles(90, 0));
        assertThat(session.shaft().direction()[0]).as("to the left").isCloseTo(1, within(1e-12));
        session.turn(new NeedleAngles(90, 30));
        assertThat(session.shaft().direction()[2]).as("to the head").isCloseTo(0.5, within(1e-12));
        session.turn(NeedleAngles.of(new double[] {1, 0, 0}));
        session.advance(15, AT_ONCE);
        next(session);
        assertThat(session.record().count(AttemptEvent.Kind.REDIRECTION)).isZero();
        session.turn(new NeedleAngles(88, 0));
        session.turn(new NeedleAngles(86, 0));
        assertThat(session.record().count(AttemptEvent.Kind.REDIRECTION)).isEqualTo(1);
        session.advance(16, AT_ONCE);
        next(session);
        session.turn(new NeedleAngles(85, 0));
        assertThat(session.record().count(AttemptEvent.Kind.REDIRECTION)).isEqualTo(2);
    }

    /** A needle that is pointed at a place is turned as one to angles is. */
    @Test
    void pointedAtAPlaceBeforeThePunctureItIsNotRedirectedAndInTheSkinOnceBetweenTwoMovements() {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 0}, new double[] {90, 0, 20});
        session.redirect(new double[] {90, 0, 10});
        session.redirect(session.targetNow());
        session.advance(15, AT_ONCE);
        next(session);
        assertThat(session.record().count(AttemptEvent.Kind.REDIRECTION)).isZero();
        session.redirect(new double[] {90, 0, 10});
        session.turn(new NeedleAngles(88, 0));
        session.redirect(session.targetNow());
        assertThat(session.record().count(AttemptEvent.Kind.REDIRECTION)).isEqualTo(1);
        session.advance(16, AT_ONCE);
        next(session);
        session.redirect(new double[] {90, 0, 10});
        assertThat(session.record().count(AttemptEvent.Kind.REDIRECTION)).isEqualTo(2);
    }

    /** The liver is 100 mm thick. */
    @Test
    void behindTheLiverNoCapsuleIsPushed() {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 0}, new double[] {90, 0, 0});
        session.advance(150, 50);
        while (session.isMoving()) {
            next(session);
        }
        assertThat(session.load().inLiver()).isFalse();
        assertThat(session.load().capsulePushMm()).isZero();
        assertThat(session.record().loads().capsulePushMm()).isBetween(0.0, 3.5);
    }

    @Test
    void aimedObliquelyTheErrorPartsIntoAxialAndLateral() {
        NeedleInsertion session = session(20);
        // Up along 3-4-5: the target goes down by d, so 3/5 d toward the skin along the needle, 4/5 d aside.
        session.place(new double[] {0, 0, -67.5}, session.targetNow());
        until(session, 2 - FRAME_S);
        session.advance(112.5, AT_ONCE);
        next(session);
        TargetingError miss = session.sample();
        assertThat(miss.axialMm()).isCloseTo(-0.6 * AMPLITUDE_MM, within(TOLERANCE_MM));
        assertThat(miss.lateralMm()).isCloseTo(0.8 * AMPLITUDE_MM, within(TOLERANCE_MM));
        assertThat(session.record().headlines())
                .containsEntry("axial_error_mm", miss.axialMm())
                .containsEntry("lateral_error_mm", miss.lateralMm());
        assertThat(miss.toMap())
                .containsEntry("axial_mm", miss.axialMm())
                .containsEntry("lateral_mm", miss.lateralMm());
    }

    @Test
    void inTheLiverTheTipKeepsToItsTissueAndTheCapsuleIsPulled() {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 0}, session.targetNow());
        session.advance(90, AT_ONCE);
        next(session);
        double start = down(frames * FRAME_S);
        TargetingError first = session.targetingError();
        until(session, 2);
        // The tip goes down with the target: what it missed by stays, and the needle turns about the skin.
        double[] tip = session.shaft().tip();
        assertThat(tip[0]).isCloseTo(90, within(TOLERANCE_MM));
        double moved = AMPLITUDE_MM - start;
        assertThat(tip[2]).isCloseTo(-moved, within(TOLERANCE_MM));
        assertThat(session.targetingError().distanceMm()).isCloseTo(first.distanceMm(), within(TOLERANCE_MM));
        assertThat(session.shaft().rotationByLiverDeg())
                .isCloseTo(StrictMath.toDegrees(StrictMath.atan2(moved, 90)), within(TOLERANCE_MM));
        // The puncture went down by the same; the needle's line passes 40/90 of that below the axis there.
        double pull = moved * (1 - 40.0 / 90) * 90 / Math.hypot(90, moved);
        assertThat(session.shaft().capsulePullMm()).isCloseTo(pull, within(TOLERANCE_MM));
        assertThat(session.warnings()).anyMatch(w -> w.contains("capsule"));
        assertThat(session.record().capsulePullMm()).isCloseTo(pull, within(TOLERANCE_MM));
    }

    @Test
    void structuresAreRecordedInOrderWithDepthAndTime() {
        NeedleInsertion session = session(20);
        until(session, 1);
        session.place(new double[] {0, 0, 0}, new double[] {90, 0, 0});
        session.advance(90, 50);
        while (session.isMoving()) {
            next(session);
        }
        session.sample();
        session.advance(0, 100);
        while (session.shaft().isPlaced()) {
            next(session);
        }
        AttemptRecord record = session.record();
        assertThat(record.events())
                .extracting(AttemptEvent::kind)
                .containsExactly(
                        AttemptEvent.Kind.SKIN_CONTACT,
                        AttemptEvent.Kind.SKIN_PUNCTURE,
                        AttemptEvent.Kind.CAPSULE_PUNCTURE,
                        AttemptEvent.Kind.SAMPLE,
                        AttemptEvent.Kind.OUT_OF_SKIN);
        AttemptEvent capsule = record.first(AttemptEvent.Kind.CAPSULE_PUNCTURE).orElseThrow();
        // A needle of 18 G pushes the capsule by 3.5 mm before it is cut.
        assertThat(capsule.depthMm()).isCloseTo(BoxAnatomy.LIVER_FROM + 3.5, within(TOLERANCE_MM));
        // 43.5 mm at 50 mm/s, begun at 1 s.
        assertThat(capsule.timeS()).isCloseTo(1.87, within(TOLERANCE_MM));
        assertThat(record.loads().peakN()).containsOnlyKeys("skin", "wall", "capsule", "liver");
        // What the tissue moves along the needle is no path of the tip; in and out it has to be made up for at most
        // once.
        assertThat(record.driftByLiverMm()).isBetween(0.1, 1.0);
        assertThat(record.tipTravelMm()).isCloseTo(180, within(record.driftByLiverMm()));
        assertThat(record.count(AttemptEvent.Kind.SKIN_PUNCTURE)).isEqualTo(1);
        assertThat(record.inNoGoS()).isZero();
        // From the frame after that of the puncture until the sample at 2.8 s; the target is lowest at 2 s.
        assertThat(record.targetExcursionMm()).isCloseTo(AMPLITUDE_MM - down(1.04), within(TOLERANCE_MM));
        assertThat(record.toMap()).containsKeys("notice", "thresholds");
    }

    @Test
    void boneStopsTheTip() {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 35}, new double[] {90, 0, 35});
        session.advance(90, 50);
        until(session, 2);
        assertThat(session.shaft().depth()).isCloseTo(10, within(TOLERANCE_MM));
        assertThat(session.isMoving()).isFalse();
        assertThat(session.record().count(AttemptEvent.Kind.BONE_CONTACT)).isEqualTo(1);
        assertThat(session.record().inNoGoS()).isPositive();
    }

    /** A breath moves the rib by so much into the skin's side of the tip; the rib is 6 mm thick. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 0.01, 3})
    void boneStopsTheTipAgainWhereTheBreathHasMovedOverIt(double mm) {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 35}, new double[] {90, 0, 35});
        session.advance(90, 50);
        until(session, 2);
        double contactMm = session.shaft().depth();
        ribShift = new double[] {-mm, 0, 0};
        next(session);
        for (int again = 1; again <= 3; again++) {
            session.advance(90, 50);
            until(session, 2 + again);
            assertThat(session.shaft().depth()).isEqualTo(contactMm);
            assertThat(session.isMoving()).isFalse();
            assertThat(session.record().count(AttemptEvent.Kind.BONE_CONTACT)).isEqualTo(1 + again);
        }
        ribShift = new double[] {2, 0, 0};
        next(session);
        session.advance(90, 50);
        until(session, 6);
        assertThat(session.shaft().depth()).isCloseTo(12, within(TOLERANCE_MM));
        session.advance(0, 50);
        until(session, 7);
        assertThat(session.shaft().isPlaced()).as("out").isFalse();
    }

    /** A rib that moves over the needle behind its tip neither stops nor moves the tip. */
    @Test
    void boneBehindTheTipStopsNothing() {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 27}, new double[] {90, 0, 27});
        session.advance(18, AT_ONCE);
        next(session);
        ribShift = new double[] {0, 0, -5};
        next(session);
        session.advance(25, AT_ONCE);
        next(session);
        assertThat(session.shaft().depth()).isEqualTo(25);
        assertThat(session.record().count(AttemptEvent.Kind.BONE_CONTACT)).isZero();
    }

    @Test
    void redirectionsAndSecondAttemptsAreCounted() {
        NeedleInsertion session = session(20);
        session.place(new double[] {0, 0, 0}, new double[] {90, 0, 20});
        session.advance(20, 100);
        until(session, 0.5);
        session.redirect(session.targetNow());
        session.place(new double[] {0, 5, 0}, session.targetNow());
        session.advance(50, 100);
        until(session, 1.5);
        assertThatThrownBy(() -> session.redirect(new double[] {90, 0, 0})).hasMessageContaining("tip in the liver");
        AttemptRecord record = session.record();
        assertThat(record.count(AttemptEvent.Kind.REDIRECTION)).isEqualTo(1);
        assertThat(record.count(AttemptEvent.Kind.SKIN_CONTACT)).isEqualTo(2);
        assertThat(record.count(AttemptEvent.Kind.SKIN_PUNCTURE)).isEqualTo(2);
    }

    /** A path of 60 mm that rounding makes longer than a needle of 60 mm. */
    @Test
    void aNeedleReachesAsFarAsItIsLong() {
        double[] aim = {60 + 1e-12, 0, 0};
        NeedleInsertion session = session(20, new Needle(18, 60));
        session.place(new double[3], aim);
        session.advance(aim[0], AT_ONCE);
        next(session);
        assertThat(session.shaft().depth()).isEqualTo(60);
    }

    /** From 100 mm deep the liver goes 20 mm farther than a needle of 105 mm is long, and comes back. */
    @Test
    void tissueThatGoesFartherThanTheNeedleIsLongSlipsOffItsTip() {
        NeedleInsertion session = session(20, new Needle(18, 105));
        session.place(new double[] {0, 0, -20}, new double[] {100, 0, -20});
        session.advance(100, AT_ONCE);
        next(session);
        assertThat(session.shaft().isTipAnchored()).isTrue();
        double[][] shiftAndDepth = {{3, 103}, {20, 105}, {24, 105}, {0, 81}};
        for (double[] step : shiftAndDepth) {
            frames++;
            session.update(
                    body.frame(frames * FRAME_S, 0, new double[] {step[0], 0, 0}, -100, ribShift),
                    RespiratoryPhase.INSPIRATION);
            assertThat(session.shaft().depth()).isCloseTo(step[1], within(TOLERANCE_MM));
            assertThat(session.shaft().depth()).isLessThanOrEqualTo(105);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {60.501, 60.52, 60.6})
    void whatIsBeyondANeedleIsSaidToBe(double mm) {
        NeedleInsertion session = session(20, new Needle(18, 60.5));
        assertThatThrownBy(() -> session.place(new double[3], new double[] {mm, 0, 0}))
                .hasMessage("needle: found 60.5 mm for a path of 60.6 mm, expected a longer needle or a nearer entry");
        session.place(new double[3], new double[] {60, 0, 0});
        assertThatThrownBy(() -> session.advance(mm, AT_ONCE))
                .hasMessage("depth: found " + mm + " mm, expected 0 to the needle's 60.5 mm");
    }

    @Test
    void whatCannotBeIsSaidInASentenceAndChangesNothing() {
        NeedleInsertion session = session(20);
        assertThatThrownBy(() -> session.advance(10, 10)).isInstanceOf(BadInputException.class);
        assertThatThrownBy(() -> session.place(new double[] {50, 0, 0}, new double[] {90, 0, 0}))
                .hasMessageContaining("inside the body");
        assertThatThrownBy(() -> session.place(new double[] {-50, 0, 0}, new double[] {90, 0, 0}))
                .hasMessageContaining("off the skin");
        assertThatThrownBy(() -> session.place(new double[] {0, 0, 0}, new double[] {190, 0, 0}))
                .hasMessageContaining("expected a longer needle");
        assertThat(session.shaft().isPlaced()).isFalse();
        assertThatThrownBy(() -> TargetLesion.at(scene, new double[] {20, 0, 0}, 20))
                .hasMessageContaining("20.0 mm outside");
        assertThatThrownBy(() -> TargetLesion.at(scene, new double[] {90, 0, 0}, 200))
                .hasMessageContaining("diameter");
    }

    @Test
    void aRelativeMoveGoesOnFromWhereTheTipMovesToInThatDirectionAndElseFromItsDepth() {
        NeedleInsertion session = session(20);
        assertThat(session.depthAfter(2)).as("out of the body").isEqualTo(2);
        assertThat(session.depthAfter(-2)).as("out of the body").isZero();
        session.placeAtRest(new double[] {200, 0, 0}, new double[] {90, 0, 0});
        session.advance(10, 50);
        next(session);
        double depthMm = session.shaft().depth();
        assertThat(depthMm).isGreaterThan(0).isLessThan(10);
        assertThat(session.depthAfter(2)).isEqualTo(12);
        assertThat(session.depthAfter(-0.5)).isEqualTo(depthMm - 0.5);
        assertThat(session.depthAfter(1000)).isEqualTo(session.needle().lengthMm());
        session.advance(0, 1);
        assertThat(session.depthAfter(-1)).isZero();
        assertThat(session.depthAfter(2)).isEqualTo(depthMm + 2);
    }
}
