package org.phrenic.ui.window;

import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.document.YamlWriter;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.export.PngFile;
import org.phrenic.ui.session.BackgroundWorker;
import org.phrenic.ui.session.FileOpener;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.FileDialogs;

/** What the window reads and writes: chosen in dialogs, done off the event dispatch thread. */
public final class WindowFiles {
    private static final int PICTURE_SCALE = 2;

    private final JFrame frame;
    private final Session session;
    private final SceneViewport view;
    private final WindowPreferences preferences;
    private final Consumer<RehearsalPlan> planListener;

    /** @param rehearse told of a plan that was opened */
    WindowFiles(
            JFrame frame,
            Session session,
            SceneViewport view,
            WindowPreferences preferences,
            Consumer<RehearsalPlan> rehearse) {
        this.planListener = rehearse;
        this.frame = frame;
        this.session = session;
        this.view = view;
        this.preferences = preferences;
    }

    /** Opens a file or folder; what is no scenario, plan of a needle, thorax or trace is refused in a sentence. */
    public void open(Path file) {
        preferences.addRecent(file);
        BackgroundWorker.execute(
                () -> FileOpener.readPlan(file),
                plan -> plan.ifPresentOrElse(planListener, () -> session.openFile(file)),
                session::refuse);
    }

    /** Asks for a file or folder and opens it. */
    void chooseAndOpen() {
        JFileChooser chooser = new JFileChooser(preferences.folder().toFile());
        chooser.setDialogTitle("Open a scenario, a thorax folder or a trace");
        chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            File chosen = chooser.getSelectedFile();
            rememberFolder(chosen.toPath());
            open(chosen.toPath());
        }
    }

    private void rememberFolder(Path chosen) {
        Path folder = chosen.toAbsolutePath().getParent();
        if (folder != null) {
            preferences.setFolder(folder);
        }
    }

    /** Saves what is set now as a scenario. */
    void saveScenario() {
        Scenario scenario = session.scenario();
        FileDialogs.save(frame, "Save scenario", scenario.name() + ".yaml")
                .ifPresent(file -> saveInBackground(file, () -> YamlWriter.write(file, scenario.toMap())));
    }

    /** Saves the view, larger than on the screen. */
    void savePicture() {
        if (view.isUnavailable() || view.frame().isEmpty()) {
            session.refuse("There is no picture to save.");
            return;
        }
        Optional<Path> chosen = FileDialogs.save(frame, "Save picture", "phrenic.png");
        chosen.ifPresent(file -> view.snapshot(
                PICTURE_SCALE * view.getWidth(),
                PICTURE_SCALE * view.getHeight(),
                image -> SwingUtilities.invokeLater(() -> writePicture(file, image))));
    }

    private void writePicture(Path file, BufferedImage image) {
        saveInBackground(file, () -> PngFile.write(file, image));
    }

    private void saveInBackground(Path file, Runnable what) {
        BackgroundWorker.execute(
                Executors.callable(what), done -> session.note("Saved " + file + "."), session::refuse);
    }
}
