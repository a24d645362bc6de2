package org.phrenic.ui;

import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.SwingWorker;
import org.phrenic.format.YamlWriter;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.scene.PngFile;
import org.phrenic.simulation.Scenario;

/** What the window reads and writes: chosen in dialogs, done off the event dispatch thread. */
final class WindowFiles {
    private static final int PICTURE_SCALE = 2;

    private final JFrame frame;
    private final Session session;
    private final SceneView view;
    private final WindowPreferences preferences;
    private final Consumer<RehearsalPlan> rehearse;

    /** @param rehearse told of a plan that was opened */
    WindowFiles(
            JFrame frame,
            Session session,
            SceneView view,
            WindowPreferences preferences,
            Consumer<RehearsalPlan> rehearse) {
        this.rehearse = rehearse;
        this.frame = frame;
        this.session = session;
        this.view = view;
        this.preferences = preferences;
    }

    /** Opens a file or folder; what is no scenario, plan of a needle, thorax or trace is refused in a sentence. */
    void open(Path file) {
        preferences.addRecent(file);
        new Reading<>(
                        file,
                        () -> Opening.plan(file),
                        plan -> plan.ifPresentOrElse(rehearse, () -> session.load(file)),
                        sentence -> session.say(Session.Message.Kind.REFUSED, sentence))
                .execute();
    }

    /** Asks for a file or folder and opens it. */
    void chooseAndOpen() {
        JFileChooser chooser = new JFileChooser(preferences.folder().toFile());
        chooser.setDialogTitle("Open a scenario, a thorax folder or a trace");
        chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            File chosen = chooser.getSelectedFile();
            remember(chosen.toPath());
            open(chosen.toPath());
        }
    }

    private void remember(Path chosen) {
        Path folder = chosen.toAbsolutePath().getParent();
        if (folder != null) {
            preferences.setFolder(folder);
        }
    }

    /** Saves what is set now as a scenario. */
    void saveScenario() {
        Scenario scenario = session.scenario();
        Choosers.save(frame, "Save scenario", scenario.name() + ".yaml")
                .ifPresent(file -> work(file, () -> YamlWriter.write(file, scenario.toMap())));
    }

    /** Saves the view, larger than on the screen. */
    void savePicture() {
        if (view.isImpossible() || view.picture().isEmpty()) {
            session.say(Session.Message.Kind.REFUSED, "There is no picture to save.");
            return;
        }
        Optional<Path> chosen = Choosers.save(frame, "Save picture", "phrenic.png");
        chosen.ifPresent(file -> view.still(
                PICTURE_SCALE * view.getWidth(),
                PICTURE_SCALE * view.getHeight(),
                image -> SwingUtilities.invokeLater(() -> writePicture(file, image))));
    }

    private void writePicture(Path file, BufferedImage image) {
        work(file, () -> PngFile.write(file, image));
    }

    private void work(Path file, Runnable what) {
        new SwingWorker<Void, Void>() {
            @Override
            protected Void doInBackground() {
                what.run();
                return null;
            }

            @Override
            protected void done() {
                try {
                    get();
                    session.say(Session.Message.Kind.NOTE, "Saved " + file + ".");
                } catch (ExecutionException e) {
                    session.say(Session.Message.Kind.REFUSED, e.getCause().getMessage());
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        }.execute();
    }
}
