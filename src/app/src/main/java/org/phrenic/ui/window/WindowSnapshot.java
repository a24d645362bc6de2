package org.phrenic.ui.window;

import java.awt.BorderLayout;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.function.BooleanSupplier;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.ui.session.PlaybackSpeed;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Theme;

/**
 * Paints the window without a display: view, docks and status bar over a live simulation, laid out and painted by the
 * components of the window. Menu and tool bar need a display and are left out.
 */
public final class WindowSnapshot {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;
    private static final long TIMEOUT_MS = 180_000;
    private static final long POLL_MS = 20;

    private final Session session;
    private final SceneViewport view;
    private final OffscreenPanel content = new OffscreenPanel();
    private int tickCount;

    private WindowSnapshot(Session session) {
        this.session = session;
        WindowPreferences preferences = WindowPreferences.unsaved();
        AppearanceModel appearance = new AppearanceModel();
        appearance.changeStyle(style -> style.withBackground(SceneBackground.LIGHT));
        view = new SceneViewport(session, appearance);
        StatusBar status = new StatusBar();
        DockLayout layout = new DockLayout(preferences, view);
        new DockManager(session, appearance, view, layout, preferences).arrange(Workspace.RESEARCHER);
        content.add(layout, BorderLayout.CENTER);
        content.add(status, BorderLayout.SOUTH);
        content.setSize(WIDTH, HEIGHT);
        session.addListener(new Session.Listener() {
            @Override
            public void onScene(LiveScene scene) {
                status.show(scene);
            }

            @Override
            public void onTick(RunStatus now) {
                status.show(now);
                status.showFrameRate(view.framesPerS());
                tickCount++;
            }
        });
        // A window would do this when it opens.
        content.addNotify();
        content.validate();
    }

    /**
     * Runs a scenario and paints the window.
     *
     * @param timeS simulated time of the picture, s
     * @throws NoGraphicsException if nothing here draws the view, or the window's parts cannot be painted, with one
     *     sentence
     */
    public static FigureImage of(Scenario scenario, double timeS) throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        WindowSnapshot[] made = new WindowSnapshot[1];
        try {
            onEventThread(() -> {
                Theme.install(false);
                made[0] = new WindowSnapshot(new Session(scenario));
            });
            return made[0].paintAt(timeS);
        } finally {
            if (made[0] != null) {
                made[0].view.close();
                made[0].session.close();
            }
        }
    }

    private FigureImage paintAt(double timeS) throws NoGraphicsException {
        await(() -> view.isUnavailable() || view.frameCount() > 0);
        onEventThread(() -> content.shown = true);
        session.live().setSpeed(PlaybackSpeed.FLAT_OUT.factor());
        await(() -> session.live().status().timeS() >= timeS);
        long step = session.live().status().step();
        await(() -> view.isUnavailable() || view.shownStep() >= step);
        if (view.isUnavailable()) {
            throw new NoGraphicsException("The view of the window could not be drawn here");
        }
        int before = tickCount;
        await(() -> tickCount > before + 1);
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        onEventThread(() -> {
            content.validate();
            Graphics2D g = image.createGraphics();
            content.paint(g);
            g.dispose();
        });
        String altText = "The window: organs to choose at the left, the breathing thorax in the middle, parameters with"
                + " sliders at the right, plots and timeline below";
        return new FigureImage("fig2-interface", altText, "", image);
    }

    /**
     * Is not showing during layout, since text fields ask for their place on the screen if it is, and is showing
     * afterwards, since plots that do not show are not drawn.
     */
    private static final class OffscreenPanel extends JPanel {
        private boolean shown;

        OffscreenPanel() {
            super(new BorderLayout());
        }

        @Override
        public boolean isShowing() {
            return shown;
        }
    }

    private static void await(BooleanSupplier condition) throws NoGraphicsException {
        long end = System.currentTimeMillis() + TIMEOUT_MS;
        boolean[] holds = new boolean[1];
        while (true) {
            onEventThread(() -> holds[0] = condition.getAsBoolean());
            if (holds[0]) {
                return;
            }
            if (System.currentTimeMillis() > end) {
                throw new NoGraphicsException(
                        "The window could not be painted here within " + TIMEOUT_MS / 1000 + " s");
            }
            try {
                Thread.sleep(POLL_MS);
            } catch (InterruptedException stopped) {
                Thread.currentThread().interrupt();
                throw new NoGraphicsException("The window was not painted: it was interrupted", stopped);
            }
        }
    }

    private static void onEventThread(Runnable what) throws NoGraphicsException {
        try {
            SwingUtilities.invokeAndWait(what);
        } catch (InvocationTargetException e) {
            Throwable cause = e.getCause();
            String reason = cause.getMessage() == null ? cause.toString() : cause.getMessage();
            throw new NoGraphicsException("The window's parts cannot be painted here: " + reason, cause);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new NoGraphicsException("The window was not painted: it was interrupted", stopped);
        }
    }
}
