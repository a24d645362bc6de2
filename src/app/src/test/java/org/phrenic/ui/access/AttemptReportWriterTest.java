package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.jogamp.opengl.GLException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;

/** A report that cannot be written, or not whole. */
class AttemptReportWriterTest {
    private static final int SIDE = 64;
    /** Pixels of a side whose square no picture in memory has. */
    private static final int TOO_LARGE = 1 << 17;

    private static final long PATIENCE_MS = 60_000;
    private static final String SAVED = "saved";

    @TempDir
    private Path folder;

    private Session session;
    private SceneViewport view;
    private Rehearsal attempt;

    @BeforeEach
    void end() {
        List<Surface> surfaces = RehearsalPreparationTest.surfaces();
        attempt = SampledAttempts.rehearsal(surfaces, RehearsalPreparationTest.map(surfaces));
        session = EventThread.get(() -> new Session(Scenario.defaults().with("resolution=low")));
        view = EventThread.get(() -> new SceneViewport(session, new AppearanceModel()));
    }

    @AfterEach
    void close() {
        EventThread.run(view::close);
        session.close();
    }

    /** Saves into a folder; why there is no report, or else {@code saved} and why pictures are missing. */
    private String outcome(Path to, long waitMs) {
        return outcome(to, SIDE, waitMs);
    }

    private String outcome(Path to, int side, long waitMs) {
        List<String> outcomes = new ArrayList<>();
        EventThread.run(() -> new AttemptReportWriter(view, side, waitMs)
                .save(attempt, "today", to, missing -> outcomes.add(SAVED + missing), outcomes::add));
        EventThread.until("the outcome", () -> !outcomes.isEmpty());
        assertThat(outcomes).hasSize(1);
        return outcomes.get(0);
    }

    @Test
    void aPictureThatCannotBeWrittenIsToldInWordsAlone() throws IOException {
        Path file = Files.createFile(folder.resolve("a file"));
        assertThat(outcome(file, PATIENCE_MS)).contains("a file").doesNotContain("Exception", SAVED);
    }

    /** Its page shows the pictures by their names alone, whosever they are. */
    @Test
    void aReportThatFailsOnTheWayLeavesNoPageOfAnEarlierAttempt() throws IOException {
        Path page = Files.writeString(folder.resolve("report.html"), "Hit");
        Path values = Files.writeString(folder.resolve("report.json"), "{}");
        Files.createDirectories(folder.resolve("scenario.yaml/in the way"));
        assertThat(outcome(folder, 1)).contains("scenario.yaml").doesNotContain(SAVED);
        assertThat(page).doesNotExist();
        assertThat(values).doesNotExist();
    }

    @Test
    void aReportWhosePicturesAreNotDrawnIsSavedAndSaysSo() {
        EventThread.run(view::close);
        assertThat(outcome(folder, 1)).startsWith(SAVED).hasSizeGreaterThan(SAVED.length());
        assertThat(folder.resolve("report.html")).exists();
    }

    private void requireView() {
        CountDownLatch drawn = new CountDownLatch(1);
        view.runTask(gl -> drawn.countDown(), () -> {});
        EventThread.until("a view, or none", () -> drawn.getCount() == 0 || view.isUnavailable());
        assumeThat(view.isUnavailable()).as(view.unavailableReason()).isFalse();
    }

    @Test
    void aReportIsSavedWithoutThePictureThatCannotBeWrittenAndSaysSo() throws IOException {
        requireView();
        Files.createDirectories(folder.resolve("access_right.png/in the way"));
        assertThat(outcome(folder, PATIENCE_MS))
                .startsWith(SAVED)
                .contains("access_right.png")
                .doesNotContain("Exception");
        assertThat(folder.resolve("report.html"))
                .content()
                .contains("access_anterior.png", "access_posterior.png")
                .doesNotContain("access_right.png");
    }

    @Test
    void aReportWhosePicturesAreTooLargeIsSavedAndSaysSo() {
        requireView();
        assertThat(outcome(folder, TOO_LARGE, PATIENCE_MS))
                .startsWith(SAVED + "The pictures were not drawn: ")
                .contains(String.valueOf(TOO_LARGE))
                .doesNotContain("Exception");
        assertThat(folder.resolve("report.html")).exists();
    }

    @Test
    void whatTheDriverRefusesIsToldInWordsAlone() {
        requireView();
        assertThatThrownBy(() -> new AttemptReportWriter(view, SIDE, PATIENCE_MS)
                        .betweenFrames(gl -> gl.run(g -> {
                            throw new GLException("the device was lost");
                        })))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("The pictures were not drawn: drawing failed: the device was lost.");
    }

    /** After the report is saved the window may end at any time, and the report names the pictures that it has. */
    @Test
    void noPictureIsDrawnOnceTheReportIsSavedWithoutIt() throws Exception {
        CountDownLatch busy = new CountDownLatch(1);
        CompletableFuture<Void> goOn = new CompletableFuture<>();
        Consumer<OffscreenContext> work = gl -> {
            busy.countDown();
            goOn.join();
        };
        view.runTask(work, () -> {});
        EventThread.until("a busy view, or none", () -> busy.getCount() == 0 || view.isUnavailable());
        assumeThat(view.isUnavailable()).isFalse();
        assertThat(outcome(folder, 1)).startsWith(SAVED).contains("did not begin");
        CountDownLatch idle = new CountDownLatch(1);
        view.runTask(gl -> idle.countDown(), () -> {});
        goOn.complete(null);
        assertThat(idle.await(PATIENCE_MS, TimeUnit.MILLISECONDS)).isTrue();
        assertThat(folder).isDirectoryNotContaining("glob:**.png");
    }
}
