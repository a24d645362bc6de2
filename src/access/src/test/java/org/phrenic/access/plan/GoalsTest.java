package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.breathing.RespiratoryPhase;

/** Goals of attempts on a target of 20 mm in a depth of 90 mm, beside a lung and ribs that lie before the liver. */
class GoalsTest {
    private static final double AT_ONCE = 1e6;
    private static final double FRAME_S = 0.02;
    private static final Needle CORE = new Needle(18, 150, 20);

    private final BoxAnatomy body = new BoxAnatomy();
    private final MovingAnatomy scene = new MovingAnatomy(body.surfaces);
    private NeedleInsertion needle;
    private int frames;

    private void begin(Needle tube) {
        scene.update(body.still(0));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, -20}, 20);
        needle = new NeedleInsertion(scene, target, tube, NoGoZone.defaults());
        next();
    }

    private void next() {
        needle.update(body.still(FRAME_S * frames), RespiratoryPhase.PAUSE);
        frames++;
    }

    /** A sample at a depth of a needle that goes straight in at a height. */
    private void sample(double heightMm, double depthMm) {
        needle.place(new double[] {0, 0, heightMm}, new double[] {90, 0, heightMm});
        needle.advance(depthMm, AT_ONCE);
        next();
        needle.sample();
    }

    private static Goals.GoalResult result(String goal, double limit, AttemptRecord record) {
        return new Goals(false, Map.of(goal, limit)).evaluate(record).get(0);
    }

    /** An attempt of the list may puncture the skin several times. */
    @Test
    void puncturesOfTheSkinAreNotCalledAttempts() {
        assertThat(new Goals(false, Map.of("attempts_at_most", 1.0)).describe())
                .containsExactly("skin punctures: at most 1");
    }

    @Test
    void aGoalOfNoLungIsMissedByACoreThatIsThrownThroughIt() {
        begin(CORE);
        sample(115, 15);
        AttemptRecord record = needle.record();
        for (String goal : new String[] {"lung_s_at_most", "no_go_s_at_most"}) {
            Goals.GoalResult none = result(goal, 0, record);
            assertThat(none.reached()).as(goal).isFalse();
            assertThat(none.value()).isZero();
            assertThat(none.reachedText(String::valueOf)).contains("core");
            assertThat(none.toMap()).containsEntry("touched_by_core", true);
            assertThat(result(goal, 1, record).reached())
                    .as("the throw takes no time")
                    .isTrue();
        }
    }

    @Test
    void aGoalOfNoBoneIsMissedByACoreThatIsFiredAtARib() {
        begin(CORE);
        sample(35, 4);
        assertThat(result("bone_contacts_at_most", 0, needle.record()).reached())
                .isFalse();
        assertThat(result("no_go_s_at_most", 0, needle.record()).reached()).isFalse();
        assertThat(result("lung_s_at_most", 0, needle.record()).reached())
                .as("the rib ends the throw before the lung")
                .isTrue();
    }

    /** The first sample lies on the axis of the target and 30 mm before it; the second hits, 8 mm beside the middle. */
    @Test
    void theLateralErrorOfAGoalIsThatOfTheSampleThatHit() {
        begin(Needle.standard());
        sample(-20, 60);
        assertThat(result("lateral_mm_at_most", 5, needle.record()).value()).isCloseTo(0, within(1e-3));
        sample(-28, 90);
        assertThat(needle.record().hit()).isTrue();
        Goals.GoalResult aside = result("lateral_mm_at_most", 5, needle.record());
        assertThat(aside.value()).isCloseTo(8, within(1e-3));
        assertThat(aside.reached()).isFalse();
        assertThat(result("lateral_mm_at_most", 9, needle.record()).reached()).isTrue();
    }

    /**
     * In at the first image, out 1 s later; two turns on the way, and a liver that goes down by 9 mm while the tip is
     * 90 mm deep, so that the capsule in a depth of 40 mm is pulled by five ninths of that.
     */
    @Test
    void eachGoalIsHeldAgainstItsOwnMeasure() {
        begin(Needle.standard());
        needle.place(new double[] {0, 0, -20}, new double[] {90, 0, -20});
        needle.advance(15, AT_ONCE);
        next();
        needle.turn(new NeedleAngles(88, 0));
        needle.advance(16, AT_ONCE);
        next();
        needle.turn(new NeedleAngles(90, 0));
        needle.advance(90, AT_ONCE);
        next();
        needle.update(body.frame(1, 0, new double[] {0, 0, -9}, 0, 0), RespiratoryPhase.PAUSE);
        AttemptRecord record = needle.record();
        assertThat(result("attempts_at_most", 1, record).value()).isEqualTo(1);
        assertThat(result("redirections_at_most", 1, record).value()).isEqualTo(2);
        assertThat(result("redirections_at_most", 1, record).reached()).isFalse();
        assertThat(result("redirections_at_most", 2, record).reached()).isTrue();
        assertThat(result("inside_s_at_most", 1, record).value()).isCloseTo(1 - FRAME_S, within(FRAME_S));
        assertThat(result("inside_s_at_most", 1, record).reached()).isTrue();
        assertThat(result("no_go_s_at_most", 0, record).value()).isZero();
        double pull = 9 * (1 - 40.0 / 90) * 90 / Math.hypot(90, 9);
        assertThat(result("capsule_pull_mm_at_most", 4, record).value()).isCloseTo(pull, within(0.02));
        assertThat(result("capsule_pull_mm_at_most", 4, record).reached()).isFalse();
        assertThat(result("capsule_pull_mm_at_most", 6, record).reached()).isTrue();
    }

    @Test
    void withoutASampleThereIsNoLateralError() {
        begin(Needle.standard());
        Goals.GoalResult aside = result("lateral_mm_at_most", 5, needle.record());
        assertThat(aside.reached()).isFalse();
        assertThat(aside.toMap()).containsEntry("value", "no sample");
    }

    @Test
    void aCoreThatTouchesNothingAtRiskReachesGoalsOfNone() {
        begin(CORE);
        sample(-20, 80);
        for (String goal : new String[] {"lung_s_at_most", "no_go_s_at_most", "bone_contacts_at_most"}) {
            assertThat(result(goal, 0, needle.record()).reached()).as(goal).isTrue();
        }
    }
}
