package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;

/** A robot on boxes whose liver goes down by 12 mm in a breath of 4 s with a pause of 1 s at end-expiration. */
class RobotOperatorTest {
    private static final RobotOperator.Hand STEADY = new RobotOperator.Hand(0.25, 0.1, 0, 0, 0, 0, 0);
    private static final int MOMENTS = 40;
    private static final double PERIOD_S = 4;

    @TempDir
    Path folder;

    private RehearsalPlan plan;
    private MovingAnatomy anatomy;
    private TargetAccess access;

    @BeforeEach
    void recordABreath() throws IOException {
        recordABreath(12, "");
    }

    /**
     * A breath in which liver and target go down by some mm and the lung by twice as much, and a plan with settings of
     * its own.
     */
    private void recordABreath(double mm, String settings) throws IOException {
        plan = RehearsalPlan.read(Files.writeString(
                folder.resolve("plan.yaml"),
                settings + "target: {rest_mm: [90, 0, -10], diameter_mm: 20}\nsteps: []\n"));
        BoxAnatomy body = new BoxAnatomy();
        anatomy = new MovingAnatomy(body.surfaces);
        anatomy.update(body.still(0));
        List<BreathMoment> cycle = new ArrayList<>();
        for (int i = 0; i < MOMENTS; i++) {
            double t = PERIOD_S * i / MOMENTS;
            double down = t < 3 ? mm / 2 * (1 - StrictMath.cos(2 * Math.PI * t / 3)) : 0;
            RespiratoryPhase phase = t < 1.5
                    ? RespiratoryPhase.INSPIRATION
                    : t < 3 ? RespiratoryPhase.EXPIRATION : RespiratoryPhase.PAUSE;
            cycle.add(new BreathMoment(
                    body.frame(t, t / PERIOD_S, new double[] {0, 0, -down}, 2 * down - 100, 0), phase, PERIOD_S));
        }
        try (Workers workers = Workers.of(1)) {
            access = TargetAccess.of(anatomy, cycle, plan.target(anatomy), plan.needle(), plan.avoided(), workers);
        }
    }

    /** Mean tilt of a needle whose way to the target rises by an angle from the axial plane, degrees. */
    private double meanTiltDeg(double cranialDeg) {
        RobotOperator.Hand unsteady = new RobotOperator.Hand(0.25, 0.1, 2.7, 0, 0, 0, 0);
        double[] entry = {0, 0, -10 - 90 * StrictMath.tan(StrictMath.toRadians(cranialDeg))};
        double length = 90 / StrictMath.cos(StrictMath.toRadians(cranialDeg));
        double sum = 0;
        int n = 200;
        for (int seed = 0; seed < n; seed++) {
            TargetingError error = new RobotOperator(plan, anatomy, access, entry, unsteady, true)
                    .attempt(seed)
                    .samples()
                    .get(0);
            sum += StrictMath.toDegrees(StrictMath.asin(error.lateralMm() / length)) / n;
        }
        return sum;
    }

    /** The errors of a hand are those of its needle, which leans by as much at any angle to the axial plane. */
    @Test
    void theHandErrsByAsMuchHoweverSteepTheNeedleStands() {
        double level = meanTiltDeg(0);
        assertThat(level).isCloseTo(3.4, within(0.2));
        assertThat(meanTiltDeg(50)).isCloseTo(level, within(0.1));
    }

    private AttemptRecord record(double[] entry, RobotOperator.Hand hand, boolean held) {
        return new RobotOperator(plan, anatomy, access, entry, hand, held).attempt(1);
    }

    private TargetingError sample(RobotOperator.Hand hand, boolean held, long seed) {
        double[] entry = {0, 0, -10};
        return new RobotOperator(plan, anatomy, access, entry, hand, held)
                .attempt(seed)
                .samples()
                .get(0);
    }

    @Test
    void aSteadyHandMissesByTheMotionOfTheTargetAlone() {
        assertThat(sample(STEADY, true, 1).distanceMm()).as("held").isCloseTo(0, within(1e-3));
        // 90 mm at 50 mm/s take longer than the pause: the needle is in the liver after 0.8 s and goes with it then.
        assertThat(sample(STEADY, false, 1).distanceMm()).as("free").isGreaterThan(0.05);
    }

    /** The sample is the core, which begins at the tip. */
    @Test
    void theMiddleOfACoreIsTakenInTheTarget() throws IOException {
        recordABreath(12, "needle: {core_mm: 20}\n");
        assertThat(sample(STEADY, true, 1).distanceMm()).isCloseTo(0, within(1e-3));
    }

    @Test
    void aGatedNeedleStandsStillWhileTheTargetIsSeenAway() {
        // Along 3-4-5, 112.5 mm at 50 mm/s take 2.25 s. The target is within 3 mm of its place for 2 s of each breath
        // of 4 s: the robot stops for the other 2 s, and samples 0.25 s after it has arrived.
        double[] entry = {0, 0, -77.5};
        assertThat(record(entry, STEADY, false).insideS()).isBetween(2.25 + 2 + 0.1, 2.25 + 2 + 0.4);
        assertThat(record(entry, STEADY, true).insideS()).isBetween(2.25 + 0.2, 2.25 + 0.35);
    }

    /**
     * It is at its place all the time, within the distance at which the gate closes: after a breath, the needle takes
     * 1.8 s to it.
     */
    @Test
    void aTargetThatNeverLeavesItsPlaceIsReachedToo() throws IOException {
        recordABreath(2, "");
        for (boolean held : List.of(false, true)) {
            RobotOperator robot = new RobotOperator(plan, anatomy, access, new double[] {0, 0, -10}, STEADY, held);
            assertThat(robot.attempt(1).samples().get(0).distanceMm()).isLessThan(2);
            assertThat(robot.timeS()).isBetween(PERIOD_S + 1.8, PERIOD_S + 1.8 + 1.1);
        }
    }

    /** In proportion to a target that all but rests, the lung would be displaced by twice as much. */
    @Test
    void bodiesAreDisplacedAsTheTargetWhereItAllButRests() throws IOException {
        recordABreath(0.001, "");
        RepeatedBreath breath =
                new RepeatedBreath(anatomy, access.map(), new RepeatedBreath.Unsteadiness(0, 2, 1 / PERIOD_S, 0));
        breath.begin(1);
        int lung = anatomy.structures().size() - 1;
        double[] heights = IntStream.range(0, MOMENTS)
                .mapToDouble(i -> breath.at(PERIOD_S * i / MOMENTS).positions(lung)[2])
                .sorted()
                .toArray();
        assertThat(heights[MOMENTS - 1] - heights[0]).isCloseTo(2 * 2, within(0.1));
    }

    /** The level of the breath wanders by a hundred metres, so that the target passes its place in no time. */
    @Test
    void aNeedleThatDoesNotArriveIsToldAsSuch() {
        RobotOperator.Hand lost = new RobotOperator.Hand(0.25, 0.1, 0, 0, 1e5, 0, 0);
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> sample(lost, false, 1))
                .withMessageContaining("plan.yaml: found a needle that does not arrive in 120 s");
    }

    /** The target passes its place for less than a tenth of a second in several breaths, too short a time to go on. */
    @Test
    void aNeedleThatIsInDoesNotWaitForEverToGoOn() {
        RobotOperator.Hand lost = new RobotOperator.Hand(0.25, 0.1, 0, 0, 600, 0, 0);
        List<String> told = new ArrayList<>();
        for (int seed = 0; seed < 40; seed++) {
            RobotOperator robot = new RobotOperator(plan, anatomy, access, new double[] {0, 0, -10}, lost, false);
            try {
                robot.attempt(seed);
            } catch (BadInputException lostOnTheWay) {
                told.add(lostOnTheWay.getMessage());
            }
            assertThat(robot.timeS()).isLessThan(120 + 1);
        }
        assertThat(told).anyMatch(reason -> reason.contains("does not arrive in 120 s"));
    }

    @Test
    void driftInAHeldBreathMovesTheTargetTowardTheHeadUntilTheNeedleIsInTheLiver() {
        RobotOperator.Hand drifting = new RobotOperator.Hand(0.25, 0.1, 0, 0, 0, 0, 1);
        TargetingError error = sample(drifting, true, 1);
        // 0.1 s of latency and 0.87 s until the capsule is cut at 43.5 mm. Afterwards the liver carries the tip, and as
        // the needle turns about the skin, it makes up for a part at the depth of the target.
        assertThat(error.lateralMm()).isBetween(0.3, 0.97);
        assertThat(error.axialMm()).isCloseTo(0, within(0.1));
    }

    @Test
    void levelsThatDifferFromBreathToBreathMoveTheTargetBetweenBreaths() {
        RobotOperator.Hand uneven = new RobotOperator.Hand(0.25, 0.1, 0, 0, 3, 0, 0);
        double squares = 0;
        for (int seed = 0; seed < 20; seed++) {
            squares += Math.pow(sample(uneven, false, seed).distanceMm(), 2) / 20;
        }
        assertThat(Math.sqrt(squares)).isGreaterThan(sample(STEADY, false, 1).distanceMm());
    }

    @Test
    void anUnsteadyHandMissesByItsErrorsAndTheSameSeedGivesTheSame() {
        double lateral = 0;
        double axial = 0;
        int n = 60;
        for (int i = 0; i < n; i++) {
            TargetingError error = sample(RobotOperator.Hand.STANDARD, true, i);
            lateral += error.lateralMm() * error.lateralMm() / n;
            axial += error.axialMm() * error.axialMm() / n;
        }
        // Two angles of 2.7 degrees at 90 mm; a depth of 2.2 mm; heartbeat and drift add less than 1 mm.
        double expected = 90 * StrictMath.toRadians(2.7) * Math.sqrt(2);
        assertThat(Math.sqrt(lateral)).isCloseTo(expected, within(0.25 * expected));
        assertThat(Math.sqrt(axial)).isCloseTo(2.2, within(0.6));
        assertThat(sample(RobotOperator.Hand.STANDARD, false, 7))
                .isEqualTo(sample(RobotOperator.Hand.STANDARD, false, 7));
    }
}
