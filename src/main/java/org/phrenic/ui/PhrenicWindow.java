package org.phrenic.ui;

import java.awt.AWTError;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.scene.Background;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/** The window: the breathing thorax in the middle, docks about it. Made and used on the event dispatch thread. */
public final class PhrenicWindow {
    private static final int WIDEST = 1440;
    private static final int HIGHEST = 900;
    private static final double OF_SCREEN = 0.94;

    private final JFrame frame = new JFrame("Phrenic");
    private final WindowPreferences preferences;
    private final Session session;
    private final Looks looks = new Looks();
    private final SceneView view;
    private final Docks docks;
    private final DockLayout layout;
    private final Banner banner = new Banner();
    private final LoadingCard loading;
    private final WelcomeCard welcome;
    private final StatusLine status = new StatusLine();
    private final LogWindow log = new LogWindow();
    private final Relook relook = new Relook();
    private final WindowFiles files;
    private final Commands commands;
    private final ToolBar tools;
    private final CountDownLatch closed = new CountDownLatch(1);

    /**
     * Whether a window can be opened here. A display that is named but does not answer counts as none.
     */
    public static boolean isPossible() {
        if (GraphicsEnvironment.isHeadless()) {
            return false;
        }
        try {
            return GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError e) {
            return false;
        }
    }

    /**
     * Opens the window and returns when it was closed.
     *
     * @param file scenario, thorax folder or trace to open; empty for a quiet breath of the virtual adult male
     * @throws org.phrenic.format.BadInputException with one sentence, if the file is none of these
     */
    public static void open(Optional<Path> file) throws InterruptedException {
        Scenario first =
                file.map(path -> Opening.read(path, Scenario.defaults())).orElse(Scenario.defaults());
        CountDownLatch[] closed = new CountDownLatch[1];
        // The body is built while the window is.
        Session session = new Session(first);
        try {
            SwingUtilities.invokeAndWait(() -> {
                WindowPreferences preferences = WindowPreferences.ofUser();
                file.ifPresent(preferences::addRecent);
                PhrenicWindow window = new PhrenicWindow(preferences, session);
                window.show();
                closed[0] = window.closed;
            });
        } catch (java.lang.reflect.InvocationTargetException e) {
            throw new IllegalStateException(
                    "the window could not be opened: " + e.getCause().getMessage(), e);
        }
        closed[0].await();
    }

    PhrenicWindow(WindowPreferences preferences, Session session) {
        this.preferences = preferences;
        this.session = session;
        Theme.install(preferences.isDark());
        SwingUtilities.updateComponentTreeUI(banner);
        SwingUtilities.updateComponentTreeUI(status);
        SwingUtilities.updateComponentTreeUI(frame);
        view = new SceneView(session, looks);
        loading = new LoadingCard(() -> session.live().cancelLoading());
        welcome = new WelcomeCard(this::enter, this::dismissWelcome);
        files = new WindowFiles(frame, session, view, preferences, this::rehearse);
        commands = new Commands(session, view, new WindowDesk(this));
        tools = new ToolBar(commands, session, view, this::enter);
        layout = new DockLayout(preferences, new Stage(view, banner, loading, welcome));
        docks = new Docks(session, looks, view, layout, preferences);
        view.onPointed(status::point);
        assemble();
        session.listen(new FromSession());
    }

    private void assemble() {
        background();
        arrange(preferences.arrangement());
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                close();
            }
        });
        frame.setJMenuBar(new Menus(commands, preferences, session, files::open, this::enter));
        frame.getContentPane().add(tools, BorderLayout.NORTH);
        frame.getContentPane().add(layout, BorderLayout.CENTER);
        frame.getContentPane().add(status, BorderLayout.SOUTH);
        frame.getRootPane()
                .setTransferHandler(new FileDrop(files::open, text -> session.say(Session.Message.Kind.REFUSED, text)));
        NumberPad.bind(frame.getRootPane(), commands.views);
        frame.setIconImages(AppIcon.images());
        frame.setMinimumSize(new Dimension(760, 520));
        place();
        tools.refresh(session);
    }

    /** Where it was, if that is still on a screen. */
    private void place() {
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        int w = Math.min(WIDEST, (int) (OF_SCREEN * screen.width));
        int h = Math.min(HIGHEST, (int) (OF_SCREEN * screen.height));
        Rectangle last = new Rectangle(
                preferences.number("x", screen.x + (screen.width - w) / 2),
                preferences.number("y", screen.y + (screen.height - h) / 2),
                preferences.number("width", w),
                preferences.number("height", h));
        frame.setBounds(screen.intersects(last) ? last : new Rectangle(screen.x, screen.y, w, h));
        if (preferences.flag("maximised", false)) {
            frame.setExtendedState(JFrame.MAXIMIZED_BOTH);
        }
    }

    void show() {
        frame.setVisible(true);
        view.requestFocusInWindow();
    }

    /** Goes through one of the doors. */
    void enter(Arrangement arrangement) {
        dismissWelcome();
        preferences.setArrangement(arrangement);
        arrange(arrangement);
    }

    /** Opens a plan behind the clinician's door. */
    void rehearse(RehearsalPlan plan) {
        enter(Arrangement.CLINICIAN);
        docks.door().open(plan);
    }

    private void arrange(Arrangement arrangement) {
        docks.arrange(arrangement);
        tools.show(arrangement);
        status.setPhysics(arrangement == Arrangement.RESEARCHER);
        layout.revalidate();
        layout.repaint();
    }

    private void dismissWelcome() {
        welcome.setVisible(false);
        welcome.getParent().revalidate();
        view.requestFocusInWindow();
    }

    private void background() {
        looks.change(style -> style.withBackground(Theme.isDark() ? Background.DARK : Background.LIGHT));
    }

    /** Changes between light and dark. */
    void toggleTheme() {
        boolean dark = !Theme.isDark();
        preferences.setDark(dark);
        Theme.install(dark);
        relook.begin(docks.all());
        background();
        tools.refresh(session);
    }

    /** Remembers what is to be remembered, and ends everything. */
    void close() {
        boolean maximised = (frame.getExtendedState() & JFrame.MAXIMIZED_BOTH) == JFrame.MAXIMIZED_BOTH;
        preferences.setFlag("maximised", maximised);
        if (!maximised) {
            preferences.setNumber("x", frame.getX());
            preferences.setNumber("y", frame.getY());
            preferences.setNumber("width", frame.getWidth());
            preferences.setNumber("height", frame.getHeight());
        }
        layout.remember();
        frame.dispose();
        log.close();
        docks.door().end();
        view.close();
        // The simulation ends its step first; nobody needs to wait for that.
        Thread end = new Thread(session::close, "phrenic-end");
        end.start();
        closed.countDown();
    }

    JFrame frame() {
        return frame;
    }

    Session session() {
        return session;
    }

    SceneView view() {
        return view;
    }

    Docks docks() {
        return docks;
    }

    Commands commands() {
        return commands;
    }

    WindowFiles files() {
        return files;
    }

    LogWindow log() {
        return log;
    }

    Banner banner() {
        return banner;
    }

    /** Shows what the session says. */
    private final class FromSession implements Session.Events {
        private String limit = "";

        @Override
        public void onLoading(String what, double share) {
            if (view.picture().isEmpty() && !view.isImpossible()) {
                view.setPlaceholder("Building the thorax: " + what);
            }
            loading.show(what, share);
            loading.getParent().revalidate();
        }

        @Override
        public void onScene(LiveScene scene) {
            status.show(scene);
            loading.setVisible(false);
            frame.setTitle(scene.scenario().name() + " - Phrenic");
            scene.notes().forEach(note -> System.getLogger(PhrenicWindow.class.getName())
                    .log(System.Logger.Level.INFO, note));
        }

        @Override
        public void onTick(Status now) {
            status.show(now);
            status.showFrames(view.picturesPerS());
            if (!now.limitSentence().equals(limit)) {
                limit = now.limitSentence();
                if (!limit.isEmpty()) {
                    session.say(Session.Message.Kind.NOTE, ParameterDock.limitInWords(now));
                }
            }
        }

        @Override
        public void onChange() {
            tools.refresh(session);
        }

        @Override
        public void onScrub() {
            tools.refresh(session);
        }

        @Override
        public void onMessage(Session.Message message) {
            System.getLogger(PhrenicWindow.class.getName()).log(System.Logger.Level.INFO, message.text());
            if (message.kind() == Session.Message.Kind.DIVERGED) {
                tools.refresh(session);
                banner.show(message, Optional.of("Back to the last good state"), () -> {
                    session.live().restoreLastGood();
                    session.live().play();
                });
            } else {
                banner.show(message);
            }
            loading.setVisible(loading.isVisible() && message.kind() == Session.Message.Kind.NOTE);
        }
    }
}
