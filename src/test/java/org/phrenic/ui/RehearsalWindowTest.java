package org.phrenic.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.simulation.Scenario;

/** The clinician's door on the virtual body at low resolution: place, insert, hit, miss, report. */
@Timeout(180)
class RehearsalWindowTest {
    private static WindowHarness window;

    @TempDir
    Path folder;

    @BeforeAll
    static void open() throws Exception {
        assumeThat(PhrenicWindow.isPossible())
                .as("no display here: the window is not tested (start Xvfb and set DISPLAY)")
                .isTrue();
        window = new WindowHarness(
                "rehearsal",
                Scenario.defaults().with("resolution=low", "lungs=embedded", "sternum=kinematic", "threads=1"));
        WindowHarness.doOnEdt(() -> window.window().enter(Arrangement.CLINICIAN));
    }

    @AfterAll
    static void close() throws Exception {
        if (window != null) {
            window.close();
        }
    }

    private static RehearsalDoor door() {
        return window.window().docks().door();
    }

    private static void ready() throws InterruptedException {
        WindowHarness.await(
                "the needle",
                () -> WindowHarness.onEdt(() -> door().stage() == RehearsalDoor.Stage.READY
                        && door().state().isPresent()));
    }

    private static NeedleState state() {
        return door().state().orElseThrow();
    }

    @Test
    void placeInsertHitReport() throws Exception {
        ready();
        window.screenshot("rehearse-ready");
        window.session().live().setSpeed(Double.POSITIVE_INFINITY);
        window.command("Best path");
        WindowHarness.await(
                "advice", () -> WindowHarness.onEdt(() -> door().advice().isPresent()));
        WindowHarness.await("an entry", () -> state().hasNeedle());
        window.breathe(0.4);
        window.screenshot("rehearse-entry");
        window.command("Go to target");
        WindowHarness.await("the needle in", () -> state().depthMm() > 20);
        window.screenshot("rehearse-in");
        WindowHarness.await("the needle there", () -> state().placed() && !state().moving());
        window.command("Take sample");
        WindowHarness.await("a sample", () -> state().samples() == 1);
        window.screenshot("rehearse-sample");
        window.command("Take out");
        WindowHarness.await(
                "a report",
                () -> WindowHarness.onEdt(
                        () -> !window.window().docks().attempts().attempts().isEmpty()));
        window.screenshot("rehearse-report");
        Rehearsal attempt = WindowHarness.onEdt(
                () -> window.window().docks().attempts().attempts().get(0));
        assertThat(attempt.record().samples()).hasSize(1);
    }
}
