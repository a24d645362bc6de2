package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.window.WindowHarness;

/** What the sections show, and what they say instead, while the needle stands still or there is none. */
@Timeout(180)
class SectionDockTest {
    private static RehearsalHarness clinic;
    private static SectionDock dock;

    @BeforeAll
    static void open() throws Exception {
        WindowHarness.assumeDisplay();
        clinic = new RehearsalHarness("sections");
        dock = WindowHarness.onEdt(() ->
                RehearsalProbeCases.descendant(clinic.window().window().frame().getRootPane(), SectionDock.class));
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

    private static Stream<SectionView> views() {
        return Stream.of(dock.along(), dock.across());
    }

    private static boolean areShown() {
        return views().allMatch(view -> view.section() != null);
    }

    private static void requireHint(String start) {
        WindowHarness.doOnEdt(() -> assertThat(views()).allSatisfy(view -> {
            assertThat(view.section()).isNull();
            assertThat(view.hint()).startsWith(start);
        }));
    }

    /** On the event dispatch thread, so that no stage of the rehearsal comes meanwhile. */
    private static void requireNoHint() {
        assertThat(views()).allSatisfy(view -> {
            assertThat(view.section()).isNull();
            assertThat(view.hint()).isEmpty();
        });
    }

    /** No further section comes of a run that stands still. */
    @Test
    void theSectionsOfAPausedNeedleComeBackWithTheHelp() throws Exception {
        clinic.begin();
        clinic.until("sections", SectionDockTest::areShown);
        clinic.rest();
        WindowHarness.doOnEdt(() -> rehearsal().setAids(Aids.PICTURES));
        requireHint("Hidden");
        WindowHarness.doOnEdt(() -> rehearsal().setAids(Aids.SECTIONS));
        assertThat(WindowHarness.onEdt(SectionDockTest::areShown)).isTrue();
        WindowHarness.doOnEdt(() -> rehearsal().setAids(Aids.SEE_THROUGH));
        assertThat(WindowHarness.onEdt(SectionDockTest::areShown)).isTrue();
        clinic.goOn();
    }

    private static RehearsalPlan waiting(Path folder) throws IOException {
        return RehearsalPlan.read(Files.writeString(
                folder.resolve("plan.yaml"),
                "title: Waiting\nset: {preset: rapid-shallow, rate_per_min: 70, resolution: low, mesh_vertices: 2000,"
                        + " lungs: embedded, sternum: kinematic, threads: 1}\nphases: 6\n"
                        + "target: {rest_mm: [-90, 0, 50], diameter_mm: 20}\nsteps: [{wait: 600}]\n"));
    }

    @Test
    void anEntryIsAskedForOnlyWhereItMayBeChosen(@TempDir Path folder) throws Exception {
        RehearsalPlan plan = waiting(folder);
        WindowHarness.doOnEdt(() -> {
            rehearsal().open(plan);
            assertThat(rehearsal().stage())
                    .as("its breath is yet to be recorded")
                    .isEqualTo(RehearsalStage.RECORDING_BREATH);
            requireNoHint();
        });
        clinic.until("the plan", () -> rehearsal()
                .plan()
                .filter(of -> of.title().equals("Waiting"))
                .isPresent());
        clinic.ready();
        requireHint("Choose an entry");
        WindowHarness.doOnEdt(() -> rehearsal().playExample());
        clinic.until("the waiting plan", () -> rehearsal().state().isPresent());
        WindowHarness.doOnEdt(() -> {
            assertThat(rehearsal().stage()).as("a plan is played").isEqualTo(RehearsalStage.PLAYING);
            requireNoHint();
        });
        WindowHarness.doOnEdt(() -> rehearsal().retry());
        clinic.ready();
        requireHint("Choose an entry");
    }
}
