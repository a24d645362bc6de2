package org.phrenic.access.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.document.YamlWriter;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

/** What is kept of a hand on the needle, at an entry 90 mm from the target. */
class HandOnNeedleTest {
    private static final double[] ENTRY = {0, 0, -20};
    private static final NeedleAngles UPRIGHT = new NeedleAngles(90, 0);
    private static final NeedleAngles TURNED = new NeedleAngles(89, 0);

    @TempDir
    Path folder;

    private final BoxAnatomy body = new BoxAnatomy();
    private final MovingAnatomy scene = new MovingAnatomy(body.surfaces);
    private final ManualStepRecorder steps = new ManualStepRecorder();
    private HandOnNeedle hand;
    private NeedleInsertion needle;
    private RehearsalPlan practice;

    @BeforeEach
    void enter() {
        scene.update(body.still(0));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, -20}, 20);
        practice = RehearsalPlan.practice(Scenario.defaults(), target, Needle.standard(), BreathCycle.PHASES);
        needle = new NeedleInsertion(scene, target, practice.needle(), practice.avoided());
        needle.update(body.still(0), RespiratoryPhase.PAUSE);
        hand = new HandOnNeedle(scene, steps);
        hand.enter(needle, ENTRY, UPRIGHT);
    }

    /** How often the program aimed, by the plan that is kept and by the same plan read from its file. */
    private long aimsByProgram() {
        RehearsalPlan kept = practice.withSteps(needle.target(), steps.stepsUntil(1), 1);
        YamlWriter.write(folder.resolve("scenario.yaml"), kept.scenario().toMap());
        YamlWriter.write(folder.resolve("plan.yaml"), kept.toMap("scenario.yaml"));
        assertThat(RehearsalPlan.read(folder.resolve("plan.yaml")).aimsByProgram())
                .isEqualTo(kept.aimsByProgram());
        return kept.aimsByProgram();
    }

    @Test
    void aNeedleThatIsTurnedAndPlacedByHandIsAimedByHand() {
        hand.turn(needle, TURNED, 0);
        hand.place(needle, 0);
        assertThat(aimsByProgram()).isZero();
    }

    @Test
    void aNeedleThatTheProgramAimedAndAHandTurnedOnIsAimedByTheProgram() {
        hand.aim(needle, 0);
        hand.turn(needle, TURNED, 0);
        hand.turn(needle, UPRIGHT, 0);
        hand.place(needle, 0);
        assertThat(aimsByProgram()).isEqualTo(1);
        assertThat(needle.shaft().direction()).as("as the hand holds it").containsExactly(UPRIGHT.direction());
    }

    /** It goes in where it stands, and not where another entry would be shown. */
    @Test
    void aNeedleThatStandsOnTheSkinTakesNoOtherEntryUntilItIsOut() {
        double[] other = {0, 10, -20};
        hand.place(needle, 0);
        hand.advance(needle, 20, 90, 0);
        assertThat(needle.shaft().depth()).isZero();
        assertThatThrownBy(() -> hand.enter(needle, other, UPRIGHT))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("entry: found the needle on the skin");
        hand.advance(needle, 0, 90, 0);
        hand.enter(needle, other, UPRIGHT);
        hand.place(needle, 0);
        assertThat(needle.shaft().entry()[1]).isCloseTo(10, within(1e-9));
    }

    @Test
    void aNeedleAtAnEntryThatIsChosenAfterTheProgramAimedIsAimedByHand() {
        hand.aim(needle, 0);
        hand.enter(needle, ENTRY, UPRIGHT);
        hand.turn(needle, TURNED, 0);
        hand.place(needle, 0);
        assertThat(aimsByProgram()).isZero();
    }
}
