package org.phrenic.ui.window;

import java.awt.AWTError;
import java.awt.Desktop;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.desktop.QuitStrategy;
import java.nio.file.Path;
import java.util.Optional;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.ui.session.FileOpener;
import org.phrenic.ui.session.Session;

/** What comes before the window is made: whether one can be opened, and what goes on beside it. */
public final class WindowStart {
    /** Number of processors from which window, picture and scene do not hold each other up while they are made. */
    private static final int PROCESSORS_FOR_ALL = 4;

    private static final String NO_WINDOW = "No window can be opened here: ";
    private static final String NO_DISPLAY = NO_WINDOW + "found no display, expected one";

    private WindowStart() {}

    /**
     * What the window shows first.
     *
     * @param scan label volume to import
     * @param plan rehearsal to open
     */
    record Content(Scenario scenario, Optional<Path> scan, Optional<RehearsalPlan> plan) {}

    /**
     * What a file that the window is opened with is; quiet breathing of the virtual adult male without one.
     *
     * @throws org.phrenic.file.BadInputException if it is nothing that the window opens
     */
    static Content content(Optional<Path> file) {
        Optional<Path> scan = file.filter(LabelVolumeFiles::isVolume);
        Optional<RehearsalPlan> plan = file.flatMap(FileOpener::readPlan);
        Scenario scenario = file.filter(path -> scan.isEmpty() && plan.isEmpty())
                .map(path -> FileOpener.readScenario(path, Scenario.defaults()))
                .orElse(Scenario.defaults());
        return new Content(scenario, scan, plan);
    }

    /** Why no window can be opened here, one sentence without a full stop; empty if one can. */
    public static Optional<String> obstacle() {
        try {
            boolean screen = !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
            return screen ? Optional.empty() : Optional.of(NO_DISPLAY);
        } catch (HeadlessException | AWTError e) {
            return Optional.of(NO_DISPLAY);
        } catch (LinkageError e) {
            return Optional.of(
                    NO_WINDOW + "a library that the windows of Java need is missing (" + e.getMessage() + ")");
        }
    }

    /** Gives the menu of macOS the name of the program, before the first use of AWT; other systems ignore it. */
    public static void nameApplication() {
        System.setProperty("apple.awt.application.name", "Phrenic");
    }

    /** Lets <i>Quit</i> of the menu of macOS close the window, which then stores its preferences. */
    private static void quitByClosing() {
        boolean mac = System.getProperty("os.name", "").startsWith("Mac");
        if (mac && Desktop.getDesktop().isSupported(Desktop.Action.APP_QUIT_STRATEGY)) {
            Desktop.getDesktop().setQuitStrategy(QuitStrategy.CLOSE_ALL_WINDOWS);
        }
    }

    /**
     * Prepares graphics and body for the window that is made next. On few processors the scene is assembled after the
     * first picture.
     */
    static Session session(Scenario first) {
        quitByClosing();
        OffscreenContext.prepare();
        return new Session(first, Runtime.getRuntime().availableProcessors() < PROCESSORS_FOR_ALL);
    }
}
