package org.phrenic.ui.access;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.YamlWriter;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.file.AtomicFile;
import org.phrenic.scene.NeedlePictures;
import org.phrenic.scene.UltrasoundPicture;
import org.phrenic.ui.session.FileWrites;
import org.phrenic.ui.view.SceneViewport;

/**
 * Writes the report of an attempt: the files of {@code phrenic rehearse}, and the plan that repeats the attempt.
 *
 * @param pictureSize width and height of its pictures, pixels
 */
public record AttemptReportWriter(SceneViewport view, int pictureSize) {
    /** Names of the files that hold an attempt; one of another attempt, or of one's own, may have the same name. */
    public static final List<String> FILES = List.of("report.json", "report.html", "plan.yaml", "scenario.yaml");

    private static final String REPORT = "report.json";
    /** Longest time for the pictures of one kind, s. */
    private static final long PICTURES_S = 120;

    /** With pictures as large as those of {@code phrenic rehearse}. */
    public AttemptReportWriter(SceneViewport view) {
        this(view, NeedlePictures.SIZE);
    }

    /**
     * Writes the files in the background; pictures are drawn between the frames of the view.
     *
     * @param date when the attempt ended, as text
     * @param done gets the reason of a failure, or an empty text, on the event dispatch thread
     */
    public void save(Rehearsal rehearsal, String date, Path folder, Consumer<String> done) {
        FileWrites.execute(
                "the report in " + folder, Executors.callable(() -> write(rehearsal, date, folder), ""), done, done);
    }

    private void write(Rehearsal rehearsal, String date, Path folder) {
        // That of an earlier attempt would describe other pictures.
        AtomicFile.delete(folder.resolve(REPORT));
        List<Picture> needle = new ArrayList<>();
        List<Picture> map = new ArrayList<>();
        String title = rehearsal.plan().title();
        if (!view.isUnavailable()) {
            for (NeedleSnapshot moment : rehearsal.needleViews()) {
                for (String file : render(rehearsal, pictures -> pictures.writeNeedleViews(folder, moment, title))) {
                    if (moment.name().startsWith("sample")) {
                        needle.add(new Picture(file, "Needle and target in the body, " + file, ""));
                    }
                }
            }
            render(rehearsal, pictures -> pictures.writeAccessMap(folder, rehearsal.map(), title))
                    .forEach(file -> map.add(new Picture(file, "Access map on the skin, " + file, "")));
        }
        RehearsalReport report = new RehearsalReport(rehearsal);
        report.images().forEach(image -> UltrasoundPicture.write(folder.resolve(image.file()), image.image()));
        RehearsalPlan plan = rehearsal.plan();
        YamlWriter.write(folder.resolve("scenario.yaml"), plan.scenario().toMap());
        YamlWriter.write(folder.resolve("plan.yaml"), plan.toMap("scenario.yaml"));
        String html = HtmlPage.format(report.document(needle, map, date));
        AtomicFile.write(folder.resolve("report.html"), html);
        JsonWriter.write(folder.resolve(REPORT), report.values());
    }

    private List<String> render(Rehearsal rehearsal, Function<NeedlePictures, List<String>> what) {
        CompletableFuture<List<String>> files = new CompletableFuture<>();
        view.runTask(gl -> {
            try (NeedlePictures pictures = NeedlePictures.using(gl, rehearsal.surfaces(), pictureSize)) {
                files.complete(what.apply(pictures));
            } catch (RuntimeException | Error e) {
                files.completeExceptionally(e);
            }
        });
        try {
            // After the view has ended no task runs: the report is written without pictures.
            return files.completeOnTimeout(List.of(), PICTURES_S, TimeUnit.SECONDS)
                    .join();
        } catch (CompletionException e) {
            throw e.getCause() instanceof RuntimeException cause
                    ? cause
                    : new IllegalStateException("the pictures were not drawn (" + e.getCause() + ")", e.getCause());
        }
    }
}
