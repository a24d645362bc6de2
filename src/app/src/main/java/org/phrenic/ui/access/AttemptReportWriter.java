package org.phrenic.ui.access;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.YamlWriter;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.file.AtomicFile;
import org.phrenic.scene.NeedlePictures;
import org.phrenic.scene.RehearsalPictures;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.ui.session.FileWrites;
import org.phrenic.ui.view.SceneViewport;

/**
 * Writes the report of an attempt: the files of {@code phrenic rehearse}, and the plan that repeats the attempt.
 *
 * @param pictureSize width and height of its pictures, pixels
 * @param waitMs longest time until the drawing of one kind of picture begins, ms
 */
public record AttemptReportWriter(SceneViewport view, int pictureSize, long waitMs) {
    /** Name of the report for readers. */
    public static final String PAGE = "report.html";

    private static final String REPORT = "report.json";
    private static final String PLAN = "plan.yaml";
    private static final String SCENARIO = "scenario.yaml";
    /** Names of the files that hold an attempt; one of another attempt, or of one's own, may have the same name. */
    public static final List<String> FILES = List.of(REPORT, PAGE, PLAN, SCENARIO);

    private static final long WAIT_MS = 120_000;

    /** With pictures as large as those of {@code phrenic rehearse}. */
    public AttemptReportWriter(SceneViewport view) {
        this(view, NeedlePictures.SIZE);
    }

    public AttemptReportWriter(SceneViewport view, int pictureSize) {
        this(view, pictureSize, WAIT_MS);
    }

    /**
     * Writes the files in the background; pictures are drawn between the frames of the view.
     *
     * @param date when the attempt ended, as text
     * @param saved gets why pictures are missing in the report, or an empty text, on the event dispatch thread
     * @param failed gets why there is no report, on the event dispatch thread
     */
    public void save(Rehearsal rehearsal, String date, Path folder, Consumer<String> saved, Consumer<String> failed) {
        FileWrites.execute("the report in " + folder, () -> write(rehearsal, date, folder), saved, failed);
    }

    private String write(Rehearsal rehearsal, String date, Path folder) {
        // Those of an earlier attempt would describe other pictures.
        AtomicFile.delete(folder.resolve(REPORT));
        AtomicFile.delete(folder.resolve(PAGE));
        RehearsalPictures pictures = new RehearsalPictures(rehearsal, folder);
        pictures.setMissing(view.unavailableReason());
        if (pictures.missing().isEmpty()) {
            pictures.draw(what -> render(rehearsal, what));
        }
        RehearsalReport report = new RehearsalReport(rehearsal);
        pictures.writeImages(report);
        RehearsalPlan plan = rehearsal.plan();
        YamlWriter.write(folder.resolve(SCENARIO), plan.scenario().toMap());
        YamlWriter.write(folder.resolve(PLAN), plan.toMap(SCENARIO));
        String html = HtmlPage.format(report.document(pictures.needle(), pictures.map(), date));
        AtomicFile.write(folder.resolve(PAGE), html);
        JsonWriter.write(folder.resolve(REPORT), report.values());
        return pictures.missing();
    }

    private void render(Rehearsal rehearsal, Consumer<NeedlePictures> what) {
        betweenFrames(gl -> {
            try (NeedlePictures pictures = NeedlePictures.using(gl, rehearsal.body(), pictureSize)) {
                what.accept(pictures);
            }
        });
    }

    /**
     * Runs a task between two frames of the view, and returns after it.
     *
     * @throws IllegalStateException if it does not begin in time, or the driver fails
     */
    void betweenFrames(Consumer<OffscreenContext> what) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        CompletableFuture<Boolean> begun = new CompletableFuture<>();
        Consumer<OffscreenContext> drawing = gl -> {
            if (!begun.complete(true)) {
                // The report is written without these pictures.
                return;
            }
            try {
                what.accept(gl);
                done.complete(null);
            } catch (RuntimeException | Error e) {
                done.completeExceptionally(e);
            }
        };
        view.runTask(drawing, () -> begun.completeExceptionally(new IllegalStateException("the view has ended")));
        try {
            if (!begun.completeOnTimeout(false, waitMs, TimeUnit.MILLISECONDS).join()) {
                throw new IllegalStateException("The view did not begin to draw them within "
                        + TimeUnit.MILLISECONDS.toSeconds(waitMs) + " s.");
            }
            done.join();
        } catch (CompletionException e) {
            Throwable cause = e.getCause();
            String why = cause.getMessage() == null ? cause.toString() : cause.getMessage();
            throw new IllegalStateException("The pictures were not drawn: " + why + ".", cause);
        }
    }
}
