package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.scenario.Assignment;
import org.phrenic.scene.AccessMapField;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.MessageListener;

/** What is shown of a former target while the next one is prepared. */
class RehearsalPreparationTest {
    private static final List<String> LOW = List.of("resolution=low");

    static List<Surface> surfaces() {
        return List.of(
                UltrasoundUpdaterTest.box("skin", StructureKind.SKIN, 0, 200, Surface.Motion.STILL),
                UltrasoundUpdaterTest.box("liver", StructureKind.LIVER, 5, 190, Surface.Motion.DEFORMING));
    }

    static AccessMap map(List<Surface> surfaces) {
        MovingAnatomy anatomy = new MovingAnatomy(surfaces);
        Frame frame = RehearsalBodyTest.frame(surfaces);
        anatomy.update(frame);
        TargetLesion target = new TargetLesion(new double[] {40, 100, 100}, 20);
        List<BreathMoment> breath = List.of(new BreathMoment(frame, RespiratoryPhase.PAUSE, 4));
        try (Workers workers = Workers.of(1)) {
            return AccessMap.of(anatomy, breath, target, Needle.standard(), NoGoZone.defaults(), workers);
        }
    }

    @Test
    void anExerciseThatIsChosenTakesTheMapOfTheFormerTargetOffTheSkin() {
        List<Surface> box = surfaces();
        AccessMapField former = new AccessMapField(box, map(box));
        RehearsalPlan exercise = RehearsalPlan.exercises().get(0).with(LOW);
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            rehearsal.colours = Optional.of(former);
            appearance.changeStyle(style -> style.withClip(Optional.of(ClipPlane.axial(0))));
            rehearsal.showBody();
            assertThat(appearance.style().clip()).as("the whole skin").isEmpty();
            assertThat(appearance.style().field()).isEqualTo(ColourField.ACCESS);
            rehearsal.open(exercise);
            assertThat(appearance.style().field()).isNotEqualTo(ColourField.ACCESS);
            assertThat(appearance.style().clip()).as("the whole body").isEmpty();
            assertThat(appearance.chosenStyle().clip()).as("for tuning").isPresent();
            assertThat(rehearsal.study()).isEmpty();
        });
    }

    /** A key beside those of the needle takes another breath. */
    @Test
    void anExerciseIsLeftWithItsBreathAndComesAgainWithIt() {
        RehearsalPlan exercise = RehearsalPlan.exercises().get(0).with(LOW);
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            List<String> said = new ArrayList<>();
            session.addListener(new MessageListener(said::add));
            rehearsal.exercise = Optional.of(exercise);
            rehearsal.preparation.followBreathing(exercise.scenario().with("depth=1.5"));
            assertThat(rehearsal.exercise()).isEmpty();
            assertThat(said)
                    .as("another scene, as of a trace, takes the target along")
                    .containsExactly(
                            "The exercise has another breath: practice on another target; Undo goes back to it.");
            rehearsal.preparation.followBreathing(exercise.scenario().with("hold=true"));
            assertThat(rehearsal.exercise()).contains(exercise);
            rehearsal.preparation.startPractice();
            rehearsal.preparation.followBreathing(exercise.scenario());
            assertThat(rehearsal.exercise()).as("left for practice").isEmpty();
        });
    }

    @Test
    void anotherResolutionOfAnExerciseIsSaid() {
        RehearsalPlan exercise = RehearsalPlan.exercises().get(0);
        List<String> said = new ArrayList<>();
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            session.addListener(new MessageListener(said::add));
            rehearsal.open(exercise.with(LOW));
            assertThat(said).isEmpty();
            session.change("Resolution", Assignment.parse("resolution=high"));
            rehearsal.open(exercise.with(List.of("resolution=medium")));
        });
        assertThat(said).containsExactly("The exercise runs at medium resolution; the scene before had high.");
    }

    /** Practice begins also where a liver is cut so that a target of the usual size has no room. */
    @Test
    void aTargetForPracticeIsAsLargeAsTheLiverAllows() {
        assertThat(practiceDiameter(190)).isEqualTo(20);
        assertThat(practiceDiameter(18)).isEqualTo(15);
        assertThat(practiceDiameter(6)).isEqualTo(5);
        assertThatThrownBy(() -> practiceDiameter(4)).hasMessageContaining("expected a larger liver");
    }

    private static double practiceDiameter(double liverMm) {
        List<Surface> surfaces = List.of(
                UltrasoundUpdaterTest.box("skin", StructureKind.SKIN, 0, 200, Surface.Motion.STILL),
                UltrasoundUpdaterTest.box("liver", StructureKind.LIVER, 5, liverMm, Surface.Motion.DEFORMING));
        return RehearsalPreparation.practiceTarget(new MovingAnatomy(surfaces), List.of(), 20)
                .diameterMm();
    }

    /** A breath is recorded flat out until another body is asked for. */
    @Test
    void theSpeedIsThatOfTheUserWhileABodyIsWaitedFor() {
        RehearsalPlan exercise = RehearsalPlan.exercises().get(0).with(LOW);
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            session.live().setSpeed(Double.POSITIVE_INFINITY);
            rehearsal.open(exercise);
            assertThat(session.live().isFlatOut()).isFalse();
        });
    }
}
