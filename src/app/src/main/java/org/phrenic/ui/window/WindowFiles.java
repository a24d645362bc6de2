package org.phrenic.ui.window;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.document.YamlWriter;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.export.PngFile;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.scan.ScanImporter;
import org.phrenic.ui.session.FileOpener;
import org.phrenic.ui.session.FileWrites;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Dialogs;
import org.phrenic.ui.widget.FileDialogs;

/** Files that the window reads and writes: chosen in dialogs, read and written off the event dispatch thread. */
public final class WindowFiles {
    private static final int PICTURE_SCALE = 2;
    private static final String WITHOUT_CHANGES =
            " It has the present values; the changes that the scenario schedules are not saved.";

    private final JFrame frame;
    private final Session session;
    private final SceneViewport view;
    private final WindowPreferences preferences;
    private final Consumer<RehearsalPlan> openPlan;
    private final ScanImporter scans;
    /** Names of the files that scenarios were saved in last, by the names that the scenarios have in the window. */
    private final Map<String, String> savedNames = new HashMap<>();

    /**
     * @param openPlan gets a rehearsal plan that is opened
     * @param display shows the import of a scan
     */
    WindowFiles(
            JFrame frame,
            Session session,
            SceneViewport view,
            WindowPreferences preferences,
            Consumer<RehearsalPlan> openPlan,
            ScanImporter.Display display) {
        this.frame = frame;
        this.session = session;
        this.view = view;
        this.preferences = preferences;
        this.openPlan = openPlan;
        scans = new ScanImporter(frame, session, display, this::open, preferences::addRecent);
        session.addListener(new OpenedFiles());
    }

    /** Lists files that were opened, a folder once its body is there. */
    private final class OpenedFiles implements Session.Listener {
        private Optional<Path> folder = Optional.empty();
        private String body = "";

        @Override
        public void onOpened(Path file, Scenario scenario) {
            folder = Optional.of(file).filter(Files::isDirectory);
            body = scenario.anatomy();
            if (folder.isEmpty()) {
                preferences.addRecent(file);
            }
        }

        @Override
        public void onScene(LiveScene scene) {
            folder.filter(loaded -> session.scenario().anatomy().equals(body)).ifPresent(preferences::addRecent);
            folder = Optional.empty();
        }
    }

    /**
     * Opens a scenario, a rehearsal plan, a thorax folder or a trace, and imports a label volume or a folder of masks;
     * anything else is refused with a message. Of files that are opened before the one before is read, the last counts.
     */
    public void open(Path file) {
        session.opening()
                .execute(
                        () -> LabelVolumeFiles.isVolume(file),
                        isVolume -> {
                            if (isVolume) {
                                scans.begin(file);
                            } else {
                                openOther(file);
                            }
                        },
                        session::refuse);
    }

    private void openOther(Path file) {
        session.opening()
                .execute(
                        () -> FileOpener.readPlan(file),
                        plan -> plan.ifPresentOrElse(read -> openPlan(file, read), () -> session.openFile(file)),
                        session::refuse);
    }

    private void openPlan(Path file, RehearsalPlan plan) {
        preferences.addRecent(file);
        openPlan.accept(plan);
    }

    void chooseAndOpen() {
        FileDialogs.openFileOrFolder(frame, "Open a scenario, a thorax folder or a trace")
                .ifPresent(this::open);
    }

    void chooseAndImport() {
        FileDialogs.openFileOrFolder(frame, "Import a label volume or a folder of masks")
                .ifPresent(scans::begin);
    }

    /**
     * Asks whether to close a window, where that loses something.
     *
     * @param sampled whether a sample waits for its needle to come out
     * @param changed whether values are not saved
     */
    boolean mayLose(boolean sampled, boolean changed) {
        Optional<String> question = lossQuestion(scans.isRunning(), sampled, changed);
        return question.filter(asked -> !Dialogs.confirmRisk(frame, "Quit", asked, "Close"))
                .isEmpty();
    }

    /** What is asked before a window is closed; empty where nothing is lost. */
    static Optional<String> lossQuestion(boolean importing, boolean sampled, boolean changed) {
        List<String> lost = new ArrayList<>();
        if (importing) {
            lost.add("the import that is under way");
        }
        if (sampled) {
            lost.add("the attempt, whose needle is not out after its sample");
        }
        if (changed) {
            lost.add("changed values that are not saved");
        }
        return Optional.of("Closing now loses " + String.join(", and ", lost) + ". Close?")
                .filter(asked -> !lost.isEmpty());
    }

    /** The imports of scans. */
    ScanImporter scans() {
        return scans;
    }

    /**
     * Saves the values that are present when the file is chosen, without steps and changes, which belong to a run;
     * {@code saved} gets them once they are saved.
     */
    void saveScenario(BiConsumer<Scenario, String> saved) {
        String before = session.scenario().name();
        FileDialogs.save(frame, "Save scenario", savedNames.getOrDefault(before, before) + ".yaml")
                .ifPresent(file -> {
                    Scenario present = session.userScenario().without(RunSettings.STEPS);
                    String left = session.isScheduled() ? WITHOUT_CHANGES : "";
                    String name = RunSettings.nameOf(file);
                    boolean renamed = present.states(RunSettings.NAME) && !name.equals(present.name());
                    Scenario named = present.with(RunSettings.NAME, name);
                    save(
                            file,
                            left + (renamed ? " Its name is that of the file, " + name + "." : ""),
                            () -> YamlWriter.write(file, named.toMap()),
                            () -> {
                                savedNames.put(before, name);
                                saved.accept(present, name);
                            });
                });
    }

    /** Saves the view at twice its size. */
    void savePicture() {
        if (view.isUnavailable() || view.frame().isEmpty()) {
            session.refuse("There is no picture to save.");
            return;
        }
        FileDialogs.save(frame, "Save picture", "phrenic.png").ifPresent(this::savePicture);
    }

    void savePicture(Path file) {
        FileWrites drawing = FileWrites.begin(file.toString());
        AtomicBoolean drawn = new AtomicBoolean();
        view.snapshot(PICTURE_SCALE, image -> {
            drawn.set(true);
            SwingUtilities.invokeLater(() -> savePicture(file, image));
        });
        Runnable end = () -> SwingUtilities.invokeLater(() -> {
            drawing.end();
            if (!drawn.get()) {
                session.refuse("The picture could not be drawn; " + file + " is not written.");
            }
        });
        // Comes after the picture, whatever becomes of that.
        view.runTask(gl -> end.run(), end);
    }

    private void savePicture(Path file, BufferedImage image) {
        save(file, "", () -> PngFile.write(file, image), () -> {});
    }

    /** @param left what is not saved, a sentence after a space; empty if nothing is left out */
    private void save(Path file, String left, Runnable write, Runnable saved) {
        FileWrites.execute(
                file.toString(),
                Executors.callable(write),
                done -> {
                    session.note("Saved " + file + "." + left);
                    saved.run();
                },
                session::refuse);
    }
}
