package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.document.JsonWriter;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.window.WindowHarness;

/** A plan of one's own in the window: what it states holds there, and after it is shown the needle is in the hand. */
@Timeout(180)
class RehearsalExerciseTest {
    /** Breathing of the window, each breath of it simulated. */
    private static final String PLAN =
            """
            title: Own plan
            set: {preset: rapid-shallow, rate_per_min: 70, resolution: low, lungs: embedded, sternum: kinematic,
              threads: 1, repeat_breath: false}
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
