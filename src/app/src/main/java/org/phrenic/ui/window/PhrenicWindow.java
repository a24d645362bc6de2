package org.phrenic.ui.window;

import java.awt.BorderLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.dock.ParameterDock;
import org.phrenic.ui.scan.ScanImporter;
import org.phrenic.ui.session.FileOpener;
import org.phrenic.ui.session.QuitAfterWrites;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.SessionMessage;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.RenderedFrame;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.AppIcon;
import org.phrenic.ui.widget.Controls;
import org.phrenic.ui.widget.Dialogs;
import org.phrenic.ui.widget.Theme;
import org.phrenic.ui.widget.ThemeUpdater;
import org.phrenic.ui.widget.TypedText;

/** The window: the 3D view, menus, tool bar, docks and status bar. Made and used on the event dispatch thread. */
public final class PhrenicWindow {
    private final JFrame frame = new JFrame("Phrenic");
    private final ScenarioTitle title = new ScenarioTitle();
    private final WindowPreferences preferences;
    private final Session session;
    private final AppearanceModel appearance = new AppearanceModel();
    private final SceneViewport view;
    private final DockManager docks;
    private final DockLayout layout;
    private final MessageBanner banner;
    private final LoadingPanel loading;
    private final LoadingPanel importing;
    private final WelcomePanel welcome;
    private final StatusBar statusBar;
    private final LogDialog log;
    private final ThemeUpdater themeUpdater = new ThemeUpdater();
    private final WindowFiles files;
    private final MenuActions commands;
    private final NeedleKeys needleKeys;
    private final MainToolBar toolBar;
    private final CountDownLatch closed = new CountDownLatch(1);
    private final QuitAfterWrites quit;

    public PhrenicWindow(WindowPreferences preferences, Session session) {
        this.preferences = preferences;
        this.session = session;
        Theme.install(preferences.isDark());
        SwingUtilities.updateComponentTreeUI(frame);
        quit = new QuitAfterWrites(session::note, this::mayLose, this::end);
        banner = new MessageBanner();
        statusBar = new StatusBar();
        log = new LogDialog();
        view = new SceneViewport(session, appearance);
        loading = new LoadingPanel("loading", "Keep the present scene", session::cancelLoading);
        importing = new LoadingPanel("importing", "Import nothing", this::cancelImport);
        welcome = new WelcomePanel(this::showWorkspace, this::dismissWelcome);
        files = new WindowFiles(frame, session, view, preferences, this::openExercise, new ImportDisplay());
        commands = new MenuActions(this);
        needleKeys = commands.needleKeys();
        toolBar = new MainToolBar(commands, session, view, this::showWorkspace);
        layout = new DockLayout(preferences, new OverlayPane(view, banner, loading, importing, welcome));
        docks = new DockManager(session, appearance, view, layout, preferences);
        view.setPickListener(statusBar::showPicked);
        assemble();
        title.read(session.scenario());
        session.addListener(new SessionListener());
    }

    private void assemble() {
        applyBackground();
        applyWorkspace(preferences.workspace());
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                quit();
            }
        });
        frame.setJMenuBar(new MainMenuBar(commands, preferences, session.edits(), files::open, this::showWorkspace));
        frame.getContentPane().add(toolBar, BorderLayout.NORTH);
        frame.getContentPane().add(layout, BorderLayout.CENTER);
        frame.getContentPane().add(statusBar, BorderLayout.SOUTH);
        frame.getRootPane().setTransferHandler(new FileDropHandler(files::open, session::refuse));
        frame.setFocusTraversalPolicy(Controls.beginningAt(view));
        commands.bindNumericKeypad(frame.getRootPane());
        frame.setIconImages(AppIcon.images());
        WindowBounds.restore(frame, preferences);
        toolBar.refresh(session);
    }

    public void show() {
        frame.setVisible(true);
        view.requestFocusInWindow();
    }

    /** Arranges the window for a task, and closes the welcome panel. */
    public void showWorkspace(Workspace workspace) {
        dismissWelcome();
        preferences.setWorkspace(workspace);
        applyWorkspace(workspace);
    }

    /** Opens a rehearsal plan in the clinician's workspace. */
    void openExercise(RehearsalPlan plan) {
        showWorkspace(Workspace.CLINICIAN);
        docks.rehearsalController().open(plan);
    }

    /** Saves the present values as a scenario. */
    void saveScenario() {
        files.saveScenario((saved, name) -> {
            title.saved(saved, name);
            frame.setTitle(title.text(session.scenario()));
        });
    }

    private void cancelImport() {
        files.scans().cancel();
    }

    private void applyWorkspace(Workspace workspace) {
        docks.arrange(workspace);
        toolBar.setWorkspace(workspace);
        commands.setWorkspace(workspace);
        docks.components().forEach(needleKeys::add);
        statusBar.setNumericsVisible(workspace == Workspace.RESEARCHER);
        layout.revalidate();
        layout.repaint();
    }

    private void dismissWelcome() {
        welcome.setVisible(false);
        welcome.getParent().revalidate();
        view.requestFocusInWindow();
    }

    private void applyBackground() {
        appearance.changeStyle(
                style -> style.withBackground(Theme.isDark() ? SceneBackground.DARK : SceneBackground.LIGHT));
    }

    /** Switches between the light and the dark look and feel. */
    void toggleTheme() {
        boolean dark = !Theme.isDark();
        preferences.setDark(dark);
        Theme.install(dark);
        themeUpdater.start(docks.components());
        applyBackground();
        toolBar.refresh(session);
    }

    /** Closes the window; where that loses something, it is asked first. */
    void quit() {
        TypedText.take(frame.getMostRecentFocusOwner());
        quit.quit();
    }

    /** Closes the window once what is being written is whole; asked again meanwhile, at once. */
    public void close() {
        quit.close();
    }

    private boolean mayLose() {
        boolean sampled = docks.rehearsalController().needle().isSampleUnreported();
        return files.mayLose(sampled, title.losesValues(session.scenario()));
    }

    /** Saves the preferences, disposes of the window and ends all threads. */
    private void end() {
        WindowBounds.save(frame, preferences);
        layout.saveSizes();
        docks.writeAttempts(problem -> Dialogs.confirmRetry(
                frame, "Attempts", problem + ".\nAttempts are lost unless they are written now.", "Lose them"));
        frame.dispose();
        log.close();
        docks.rehearsalController().shutdown();
        view.close();
        // Closing waits for the end of a step.
        new Thread(session::close, "phrenic-end").start();
        closed.countDown();
    }

    /** Counted down when the window is closed. */
    CountDownLatch closed() {
        return closed;
    }

    public JFrame frame() {
        return frame;
    }

    Session session() {
        return session;
    }

    public SceneViewport view() {
        return view;
    }

    public DockManager docks() {
        return docks;
    }

    MenuActions commands() {
        return commands;
    }

    public WindowFiles files() {
        return files;
    }

    LogDialog log() {
        return log;
    }

    public MessageBanner banner() {
        return banner;
    }

    /** Shows an import in the window. */
    private final class ImportDisplay implements ScanImporter.Display {
        @Override
        public void showProgress(String stage, double share) {
            importing.show(stage, share);
            importing.getParent().revalidate();
        }

        @Override
        public void rehearse() {
            showWorkspace(Workspace.CLINICIAN);
        }

        @Override
        public boolean isAttemptUnderWay() {
            return docks.rehearsalController().isAttemptUnderWay();
        }
    }

    private final class SessionListener implements Session.Listener {
        private static final System.Logger LOG = System.getLogger(PhrenicWindow.class.getName());

        private String limitSentence = "";

        @Override
        public void onLoading(String what, double share) {
            if (view.frame().isEmpty() && !view.isUnavailable()) {
                view.setPlaceholder("Building the thorax: " + what);
            }
            loading.show(what, share);
            loading.getParent().revalidate();
        }

        @Override
        public void onScene(LiveScene scene) {
            statusBar.show(scene);
            loading.setVisible(false);
            banner.endDivergence();
            title.opened(
                    scene.scenario(), docks.rehearsalController().exercise().map(RehearsalPlan::scenario));
            frame.setTitle(title.text(session.scenario()));
            LogDialog.logNotes(scene.body());
        }

        @Override
        public void onOpened(Path file, Scenario scenario) {
            if (FileOpener.isYaml(file)) {
                title.read(scenario);
            }
        }

        @Override
        public void onTick(RunStatus now) {
            showMoment(now);
            if (!session.live().isDiverged()) {
                banner.endDivergence();
            }
            toolBar.refreshHold();
            statusBar.showFrameRate(view.framesPerS());
            statusBar.showPace(
                    session.live().isBehindRealTime() && !session.live().isFlatOut());
            statusBar.showResolution(view.frame().map(RenderedFrame::resolution).orElse(1.0));
            if (!now.stabilityMessage().equals(limitSentence)) {
                limitSentence = now.stabilityMessage();
                if (!limitSentence.isEmpty()) {
                    session.note(ParameterDock.substepText(now));
                }
            }
        }

        @Override
        public void onChange() {
            toolBar.refresh(session);
            frame.setTitle(title.text(session.scenario()));
            loading.setVisible(loading.isVisible() && session.live().isLoading());
        }

        @Override
        public void onScrub() {
            toolBar.refresh(session);
            showMoment(session.live().status());
        }

        private void showMoment(RunStatus now) {
            session.historyFrame()
                    .ifPresentOrElse(
                            frame -> statusBar.showRecorded(
                                    session.live().history().frameTime(frame)),
                            () -> statusBar.show(now));
        }

        @Override
        public void onMessage(SessionMessage message) {
            LOG.log(System.Logger.Level.INFO, message.text());
            if (message.kind() == SessionMessage.Kind.DIVERGED) {
                toolBar.refresh(session);
                Runnable restore = () -> {
                    session.returnToLive();
                    session.live().restoreLastGood();
                };
                banner.show(message, Optional.of("Back to the last good state"), restore);
            } else {
                banner.show(message);
            }
            if (message.kind() == SessionMessage.Kind.REFUSED && isWithoutBody()) {
                view.setPlaceholder(message.text());
            }
            loading.setVisible(loading.isVisible() && session.live().isLoading());
        }

        /** Whether there is nothing to show and nothing loads, as after a first body that cannot be loaded. */
        private boolean isWithoutBody() {
            boolean waits = session.scene().isPresent() || session.live().isLoading();
            return !waits && view.frame().isEmpty() && !view.isUnavailable();
        }
    }
}
