package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import javax.swing.JComboBox;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.ScannedLesion;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.document.JsonWriter;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.RigidTendon;
import org.phrenic.scenario.Assignment;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.window.WindowHarness;

/** A plan of one's own in the window: what it states holds there, and after it is shown the needle is in the hand. */
@Timeout(180)
class RehearsalExerciseTest {
    /** Breathing of the window, each breath of it simulated. */
    private static final String PLAN =
            """
            title: Own plan
            set: {preset: rapid-shallow, rate_per_min: 70, resolution: low, mesh_vertices: 2000, lungs: embedded,
              sternum: kinematic, threads: 1, repeat_breath: false}
            phases: 6
            target: {rest_mm: [%s], diameter_mm: 20}
            """;

    private static final int MOMENTS = 6;

    private static RehearsalHarness clinic;

    @TempDir
    Path folder;

    @BeforeAll
    static void open() throws Exception {
        WindowHarness.assumeDisplay();
        clinic = new RehearsalHarness("exercise");
    }

    @AfterAll
    static void close() throws Exception {
        if (clinic != null) {
            clinic.close();
        }
    }

    private static RehearsalController rehearsal() {
        return clinic.rehearsal();
    }

    private void openPlan(String title, String steps) throws IOException, InterruptedException {
        String text = String.format(Locale.ROOT, PLAN.replace("Own plan", title), target()) + steps;
        Path file = Files.writeString(folder.resolve("own.yaml"), text);
        WindowHarness.doOnEdt(() -> clinic.window().window().files().open(file));
        clinic.until("the plan", () -> rehearsal()
                .exercise()
                .filter(plan -> plan.title().equals(title))
                .isPresent());
        clinic.ready();
    }

    private static String target() {
        double[] rest = WindowHarness.onEdt(
                () -> rehearsal().study().orElseThrow().target().restMm());
        return Arrays.stream(rest)
                .mapToObj(mm -> String.format(Locale.ROOT, "%.1f", mm))
                .collect(Collectors.joining(", "));
    }

    private static boolean repeats() {
        return WindowHarness.onEdt(() -> clinic.window().session().scenario().get(Breathing.REPEAT));
    }

    private void show() throws InterruptedException {
        WindowHarness.doOnEdt(() -> rehearsal().playExample());
        clinic.until("the end of the steps", () -> rehearsal().stage() == RehearsalStage.READY);
    }

    @Test
    void afterAPlanIsShownTheNeedleIsTakenByHandAndTheBreathIsThePlans() throws Exception {
        openPlan("Shown", "steps:\n  - place: {entry: best, aim: target}\n  - advance: {depth_mm: 12}\n");
        assertThat(repeats()).as("repeats the breath, against the plan").isFalse();
        show();
        assertThat(clinic.state().depthMm()).as("left in the body").isPositive();
        WindowHarness.doOnEdt(() -> {
            rehearsal().entrySelection().selectBest(false);
            rehearsal().needle().moveTo(8);
        });
        clinic.until("in by hand", () -> clinic.isAt(8));
        WindowHarness.doOnEdt(() -> rehearsal().needle().takeSample());
        clinic.until("a sample", () -> clinic.state().samples() == 1);
        Rehearsal byHand = clinic.ended();
        clinic.rest();
        assertThat(byHand.plan().scenario().get(Breathing.REPEAT)).isFalse();
        Rehearsal again = Rehearsal.play(byHand.plan(), (at, total, perS) -> {});
        assertThat(report(again)).isEqualTo(report(byHand));
        clinic.goOn();

        WindowHarness.doOnEdt(() -> rehearsal().startPractice());
        clinic.until("practice", () -> rehearsal()
                .plan()
                .filter(plan -> plan.title().equals("Practice"))
                .isPresent());
        clinic.ready();
        RehearsalPlan practice = WindowHarness.onEdt(() -> rehearsal().plan().orElseThrow());
        assertThat(WindowHarness.onEdt(
                        () -> rehearsal().study().orElseThrow().map().cycle().size()))
                .isEqualTo(MOMENTS);
        assertThat(practice.moments()).as("of the recorded breath").isEqualTo(MOMENTS);
    }

    private static String report(Rehearsal rehearsal) {
        return JsonWriter.format(new RehearsalReport(rehearsal).values());
    }

    @Test
    void aPlanThatIsEditedAndOpenedAgainTakesThePlaceOfTheFormerInTheList() throws Exception {
        openPlan("As it was", "steps: []\n");
        JComboBox<?> list = clinic.window().control(JComboBox.class, "Exercise");
        int listed = WindowHarness.onEdt(list::getItemCount);
        openPlan("As edited", "description: Without a goal.\nsteps: []\n");
        assertThat(WindowHarness.onEdt(list::getItemCount)).isEqualTo(listed);
        String selected = WindowHarness.onEdt(() -> String.valueOf(list.getSelectedItem()));
        assertThat(selected).isEqualTo("As edited");
        WrappingLabel about = clinic.window().control(WrappingLabel.class, "About the exercise");
        String told = WindowHarness.onEdt(about::getText);
        assertThat(told).isEqualTo("Without a goal.");

        int index = WindowHarness.onEdt(list::getSelectedIndex);
        WindowHarness.doOnEdt(() -> rehearsal().startPractice());
        clinic.ready();
        WindowHarness.doOnEdt(() -> list.setSelectedIndex(index));
        clinic.until("the exercise", () -> rehearsal().exercise().isPresent());
        assertThat(rehearsal().exercise().orElseThrow().description()).isEqualTo("Without a goal.");
        clinic.ready();
    }

    /** The plan that is kept has only the holds that were commanded. */
    @Test
    void anEditThatHoldsTheBreathBeginsTheAttemptAgain() throws Exception {
        clinic.begin();
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(8));
        clinic.until("in", () -> clinic.isAt(8));
        Session session = clinic.window().session();
        WindowHarness.doOnEdt(() -> session.change("Hold of the breath", Assignment.of("test", Breathing.HOLD, true)));
        clinic.until(
                "the start",
                () -> rehearsal().state().filter(now -> !now.placed()).isPresent());
        assertThat(WindowHarness.onEdt(() -> clinic.window().window().banner().message()))
                .contains("begins again");
        assertThat(WindowHarness.onEdt(() -> session.scenario().hold())).isFalse();
        clinic.ready();
    }

    /** Their keys lie beside those of the needle, and what they do takes the exercise with its needle away. */
    @Test
    void anotherBreathWaitsForTheNeedleAndItsUndoingGoesBackToTheExercise() throws Exception {
        openPlan("Breathed", "steps: []\n");
        clinic.begin();
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(8));
        clinic.until("in", () -> clinic.isAt(8));
        String preset = clinic.window().session().scenario().preset();
        for (String name : new String[] {"Undo", "Deep"}) {
            clinic.window().command(name);
            assertThat(WindowHarness.onEdt(
                            () -> clinic.window().window().banner().message()))
                    .as(name)
                    .contains("would end this attempt: take the needle out first (O)");
        }
        assertThat(WindowHarness.onEdt(
                        () -> clinic.window().session().scenario().preset()))
                .isEqualTo(preset);
        assertThat(clinic.state()).matches(NeedleState::placed);
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(0));
        clinic.until("out", () -> !clinic.state().placed());

        WindowHarness.doOnEdt(() -> clinic.window().session().change("Depth", Assignment.parse("depth=1.3")));
        clinic.until("practice", () -> rehearsal().exercise().isEmpty());
        assertThat(WindowHarness.onEdt(() -> clinic.window().window().banner().message()))
                .contains("Undo goes back to it");
        clinic.window().command("Undo");
        clinic.until("the exercise", () -> rehearsal().exercise().isPresent());
        clinic.ready();
        assertThat(WindowHarness.onEdt(() -> rehearsal().plan().orElseThrow().title()))
                .isEqualTo("Breathed");
    }

    private void requireNote(String note, String... commands) {
        for (String name : commands) {
            WindowHarness.doOnEdt(() -> clinic.window().session().note("Before it."));
            clinic.window().command(name);
            assertThat(WindowHarness.onEdt(
                            () -> clinic.window().window().banner().message()))
                    .as(name)
                    .startsWith(note);
        }
    }

    /** A key that does nothing looks broken. */
    @Test
    void whatCannotBeDoneYetSaysWhatToDoFirst() throws Exception {
        openPlan("Without an entry", "steps: []\n");
        requireNote(
                "Choose an entry first (E)",
                "Insert",
                "Aim for me",
                "Turn to the head",
                "Look along the needle",
                "Take sample");
        requireNote("Put the probe on the skin first (U)", "Rotate clockwise", "Tilt back", "Slide to the marker");
        clinic.begin();
        requireNote("Insert the needle first (I)", "Take sample");
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(8));
        clinic.until("in", () -> clinic.isAt(8));
        requireNote("Before it.", "Turn to the head", "Look along the needle");
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(0));
        clinic.until("out", () -> !clinic.state().placed());
    }

    private Rehearsal sampleAt(double depthMm) throws InterruptedException {
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(depthMm));
        clinic.until("in", () -> clinic.isAt(depthMm));
        WindowHarness.doOnEdt(() -> rehearsal().needle().takeSample());
        clinic.until("a sample", () -> clinic.state().samples() == 1);
        return clinic.ended();
    }

    @Test
    void theReportOfAFurtherAttemptStatesTheHelpOfItsOwn() throws Exception {
        clinic.begin();
        Rehearsal first = sampleAt(8);
        WindowHarness.doOnEdt(() -> rehearsal().setAids(Aids.PICTURES));
        Rehearsal second = sampleAt(10);
        WindowHarness.doOnEdt(() -> rehearsal().setAids(Aids.SEE_THROUGH));
        assertThat(first.plan().aids()).isEqualTo(Aids.SEE_THROUGH);
        assertThat(second.plan().aids()).isEqualTo(Aids.PICTURES);
    }

    /** An exercise on the body of the others, whose scene has more links, so that it is assembled anew. */
    private RehearsalPlan ofAnotherScene(String title) throws IOException {
        String text = PLAN.replace("Own plan", title)
                .replace("repeat_breath: false", "repeat_breath: false, links_per_node: 2")
                .replace("[%s]", "[-90, 0, 50]");
        return RehearsalPlan.read(
                Files.writeString(folder.resolve("another.yaml"), text + "aids: pictures\nsteps: []\n"));
    }

    /** Its scene runs, which the window is yet to learn, when Space is pressed twice. */
    @Test
    void anExerciseWhoseSceneBeginsIsNotTakenForOneWhoseSceneDoesNotCome() throws Exception {
        RehearsalPlan opened = ofAnotherScene("Opened");
        openPlan("Before", "steps: []\n");
        Session session = clinic.window().session();
        Session.Listener impatient = new Session.Listener() {
            @Override
            public void onLoading(String what, double share) {
                session.removeListener(this);
                while (session.live().isLoading()) {
                    LockSupport.parkNanos(100_000);
                }
                session.togglePlay();
                session.togglePlay();
            }
        };
        WindowHarness.doOnEdt(() -> {
            session.addListener(impatient);
            rehearsal().open(opened);
        });
        clinic.until(
                "an exercise",
                () -> rehearsal().plan().stream().noneMatch(plan -> plan.title().equals("Before")) && clinic.isReady());
        assertThat(WindowHarness.onEdt(() -> rehearsal().plan().orElseThrow().title()))
                .isEqualTo("Opened");
        assertThat(WindowHarness.onEdt(() -> rehearsal().pictures().aids())).isEqualTo(Aids.PICTURES);
        openPlan("After", "steps: []\n");
    }

    /** Another exercise may be chosen by mistake, and its body may take long to load. */
    @Test
    void whatIsRehearsedGoesOnWhenTheSceneOfAnotherExerciseIsCancelled() throws Exception {
        RehearsalPlan other = ofAnotherScene("Other");
        openPlan("Kept", "steps: []\n");
        requireKept("Kept", () -> {
            rehearsal().open(other);
            assertThat(rehearsal().pictures().aids()).isEqualTo(Aids.PICTURES);
            cancelLoading();
        });
        WindowHarness.doOnEdt(() -> rehearsal().startPractice());
        clinic.until("practice", () -> rehearsal().plan().orElseThrow().title().equals("Practice"));
        clinic.ready();
        double[] own = WindowHarness.onEdt(
                () -> rehearsal().study().orElseThrow().target().restMm());
        own[0] += 7;
        WindowHarness.doOnEdt(() -> rehearsal().setTarget(new ScannedLesion("own", "own", new TargetLesion(own, 20))));
        clinic.until("a target of one's own", () -> targetIs(own));
        clinic.ready();
        requireKept("Practice", RehearsalExerciseTest::cancelAnotherSceneWhenItsLoadingIsTold);
        assertThat(targetIs(own)).isTrue();
    }

    private static void cancelLoading() {
        Session session = clinic.window().session();
        assertThat(session.live().isLoading()).isTrue();
        session.cancelLoading();
    }

    /** An edit that needs another scene is cancelled as by a person, who sees its progress first. */
    private static void cancelAnotherSceneWhenItsLoadingIsTold() {
        Session session = clinic.window().session();
        session.addListener(new Session.Listener() {
            @Override
            public void onLoading(String what, double share) {
                session.removeListener(this);
                assertThat(rehearsal().stage()).isEqualTo(RehearsalStage.LOADING);
                cancelLoading();
            }
        });
        session.change("Links", Assignment.of("test", RigidTendon.LINKS_PER_NODE, 2));
    }

    private static boolean targetIs(double... rest) {
        return rehearsal()
                .study()
                .filter(study -> Arrays.equals(study.target().restMm(), rest))
                .isPresent();
    }

    /** Lets the scene of another exercise, or of an edit, be cancelled, and requires that what was rehearsed is so. */
    private static void requireKept(String title, Runnable cancelled) throws InterruptedException {
        String before = WindowHarness.onEdt(RehearsalExerciseTest::target);
        Optional<TargetAccess> map = WindowHarness.onEdt(() -> rehearsal().study());
        WindowHarness.doOnEdt(cancelled::run);
        clinic.until(
                "a map anew", () -> clinic.isReady() && !rehearsal().study().equals(map));
        assertThat(WindowHarness.onEdt(() -> rehearsal().pictures().aids())).isEqualTo(Aids.SEE_THROUGH);
        assertThat(WindowHarness.onEdt(() -> rehearsal().plan().orElseThrow().title()))
                .isEqualTo(title);
        assertThat(WindowHarness.onEdt(RehearsalExerciseTest::target)).isEqualTo(before);
    }

    /** A switch that does nothing looks broken, and a picture of other angles than the slider's misleads. */
    @Test
    void theXrayLetsAPausedSimulationGoOn() throws Exception {
        clinic.begin();
        JToggleButton beam = clinic.window().control(JToggleButton.class, "X-ray on");
        JSlider arm = clinic.window().control(JSlider.class, "C-arm to the left");
        FluoroscopyDock dock = (FluoroscopyDock) SwingUtilities.getAncestorOfClass(FluoroscopyDock.class, beam);
        clinic.rest();
        WindowHarness.doOnEdt(() -> arm.setValue(10));
        assertThat(clinic.window().session().live().isPlaying())
                .as("turned without X-rays")
                .isFalse();
        WindowHarness.doOnEdt(beam::doClick);
        clinic.until("a picture", () -> dock.shot().isPresent());
        clinic.rest();
        WindowHarness.doOnEdt(() -> {
            clinic.window().session().showHistoryFrame(0);
            arm.setValue(30);
        });
        clinic.until("the angle", () -> dock.shot().orElseThrow().arm().leftObliqueDeg() == 30);
        assertThat(WindowHarness.onEdt(() -> clinic.window().session().historyFrame()))
                .as("the past is shown no more")
                .isEmpty();
        clinic.rest();
        WindowHarness.doOnEdt(beam::doClick);
        assertThat(clinic.window().session().live().isPlaying())
                .as("switched off")
                .isFalse();
        WindowHarness.doOnEdt(() -> arm.setValue(0));
        clinic.goOn();
    }

    @Test
    void goingToTheTargetWithdrawsATipThatIsBeyondIt() throws Exception {
        clinic.begin();
        WindowHarness.doOnEdt(() -> rehearsal().needle().aimAtTarget());
        clinic.until("a needle that points at the target", () -> RehearsalHarness.pointsAtTarget(clinic.state()));
        double tooDeep = WindowHarness.onEdt(() -> clinic.state().targetDepthMm()) + 15;
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(tooDeep));
        clinic.until("beyond the target", () -> clinic.isAt(tooDeep));
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveToTarget());
        clinic.until("back", () -> !clinic.state().moving() && clinic.state().depthMm() < tooDeep - 5);
    }

    @Test
    void whatAnAttemptShowsIsNoImageOfTheAttemptBefore() throws Exception {
        openPlan("Without a probe", "steps:\n  - wait: 600\n");
        WindowHarness.doOnEdt(() -> {
            var map = rehearsal().study().orElseThrow().map();
            rehearsal()
                    .probe()
                    .put(map.pointAtRest(
                            map.best(AccessMap.SUFFICIENT_MARGIN_MM).orElseThrow()));
        });
        UltrasoundView view = WindowHarness.onEdt(() ->
                RehearsalProbeCases.descendant(clinic.window().window().frame().getRootPane(), UltrasoundView.class));
        clinic.until("an image", () -> view.shot().isPresent());
        WindowHarness.doOnEdt(() -> rehearsal().playExample());
        assertThat(WindowHarness.onEdt(view::shot)).isEmpty();
        // After it the run is that of the example.
        clinic.window().session().live().recordedScenario();
        clinic.window().breathe(0.3);
        assertThat(WindowHarness.onEdt(view::shot)).isEmpty();
        WindowHarness.doOnEdt(() -> {
            rehearsal().probe().lift();
            rehearsal().retry();
        });
        clinic.ready();
    }

    @Test
    void aPlanThatIsRefusedEndsThereAndTheNeedleIsTakenByHand() throws Exception {
        openPlan("Refused", "steps:\n  - wait: 0.1\n  - advance: {depth_mm: 12}\n");
        show();
        assertThat(WindowHarness.onEdt(() -> clinic.window().window().banner().message()))
                .contains("step 2, advance");
        WindowHarness.doOnEdt(() -> rehearsal().entrySelection().selectBest(false));
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(8));
        clinic.until("in by hand", () -> clinic.isAt(8));
        assertThat(clinic.state()).matches(NeedleState::placed);
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(0));
        clinic.until("out", () -> !clinic.state().placed());
    }
}
