package org.phrenic.ui;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.phrenic.format.AtomicFile;
import org.phrenic.format.HtmlPage;
import org.phrenic.format.Json;
import org.phrenic.format.ReportDocument.Picture;
import org.phrenic.format.YamlWriter;
import org.phrenic.rehearsal.NeedleView;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.rehearsal.RehearsalReport;
import org.phrenic.scene.NeedlePictures;

/** Writes the report of an attempt into a folder: what {@code phrenic rehearse} writes, and the plan that does the attempt again. */
final class AttemptSaver {
    private final SceneView view;

    AttemptSaver(SceneView view) {
        this.view = view;
    }

    /**
     * Writes; pictures are drawn one by one between those of the view, the report last.
     *
     * @param done told on the event dispatch thread: empty if all is written, else why not
     */
    void save(Rehearsal rehearsal, Path folder, Consumer<String> done) {
        Thread writer = new Thread(() -> {
            String problem;
            try {
                write(rehearsal, folder);
                problem = "";
            } catch (RuntimeException e) {
                problem = String.valueOf(e.getMessage());
            }
            String said = problem;
            SwingUtilities.invokeLater(() -> done.accept(said));
        });
        writer.setName("phrenic-report");
        writer.setDaemon(true);
        writer.start();
    }

    private void write(Rehearsal rehearsal, Path folder) {
        List<Picture> needle = new ArrayList<>();
        List<Picture> map = new ArrayList<>();
        String title = rehearsal.plan().title();
        if (!view.isImpossible()) {
            for (NeedleView moment : rehearsal.views()) {
                for (String file : drawn(rehearsal, pictures -> pictures.needle(folder, moment, title))) {
                    if (moment.name().startsWith("sample")) {
                        needle.add(new Picture(file, "Needle and target in the body, " + file, ""));
                    }
                }
            }
            drawn(rehearsal, pictures -> pictures.map(folder, rehearsal.map(), title))
                    .forEach(file -> map.add(new Picture(file, "Access map on the skin, " + file, "")));
        }
        RehearsalReport report = new RehearsalReport(rehearsal);
        YamlWriter.write(
                folder.resolve("scenario.yaml"), rehearsal.plan().scenario().toMap());
        YamlWriter.write(folder.resolve("plan.yaml"), rehearsal.plan().toMap("scenario.yaml"));
        AtomicFile.write(folder.resolve("report.html"), HtmlPage.of(report.document(needle, map)));
        Json.write(folder.resolve("report.json"), report.values());
    }

    private List<String> drawn(Rehearsal rehearsal, Function<NeedlePictures, List<String>> what) {
        CompletableFuture<List<String>> files = new CompletableFuture<>();
        view.work(gl -> {
            try (NeedlePictures pictures = NeedlePictures.with(gl, rehearsal.surfaces())) {
                files.complete(what.apply(pictures));
            } catch (RuntimeException e) {
                files.completeExceptionally(e);
            }
        });
        return files.join();
    }
}
