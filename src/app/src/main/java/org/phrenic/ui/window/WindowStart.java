package org.phrenic.ui.window;

import java.awt.AWTError;
import java.awt.Desktop;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.desktop.QuitStrategy;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.ui.access.AttemptHistory;
import org.phrenic.ui.session.FileOpener;
import org.phrenic.ui.session.ScenarioStore;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;

/** Opens the window; what comes before it is made: whether one can be opened, and what goes on beside it. */
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

    /**
     * Opens the window and returns when it is closed.
     *
     * @param file scenario, rehearsal plan, thorax folder or trace to open, or label volume to import; empty for quiet
     *     breathing of the virtual adult male
     * @throws org.phrenic.file.BadInputException if the file is none of these
     */
    public static void open(Optional<Path> file) throws InterruptedException {
        Content content = content(file);
        CountDownLatch[] closed = new CountDownLatch[1];
        Session session = session(content.scenario());
        OffscreenContext.awaitToolkit();
        try {
            SwingUtilities.invokeAndWait(() -> {
                WindowPreferences preferences = WindowPreferences.ofUser();
                file.filter(path -> content.scan().isEmpty()).ifPresent(preferences::addRecent);
                PhrenicWindow window = new PhrenicWindow(preferences, session);
                window.docks()
                        .keepAttempts(AttemptHistory.in(ScenarioStore.ofUser().dataFolder()));
                window.show();
                WindowPreferences.obstacle().ifPresent(session::note);
                content.scan().ifPresent(window.files()::open);
                content.plan().ifPresent(window::openExercise);
                closed[0] = window.closed();
            });
        } catch (java.lang.reflect.InvocationTargetException e) {
            throw new IllegalStateException(
                    "the window could not be opened: " + e.getCause().getMessage(), e);
        }
        closed[0].await();
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
