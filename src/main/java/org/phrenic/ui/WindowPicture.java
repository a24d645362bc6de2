package org.phrenic.ui;

import java.awt.BorderLayout;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.Optional;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.phrenic.scene.Background;
import org.phrenic.scene.FigurePicture;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.Status;

/**
 * The window painted without a screen: its view, docks and status line over a live simulation, laid out and painted by the code that does so on a screen. Menu and tool bar, which ask for a screen, are left
 * out.
 */
public final class WindowPicture {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;
    private static final long PATIENCE_MS = 180_000;
    private static final long LOOK_MS = 20;

    private final Session session;
    private final SceneView view;
    private final OffScreen content = new OffScreen();
    private int ticks;

    private WindowPicture(Session session) {
        this.session = session;
        WindowPreferences preferences = new WindowPreferences(new MemoryPreferences());
        Looks looks = new Looks();
        looks.change(style -> style.withBackground(Background.LIGHT));
        view = new SceneView(session, looks);
        StatusLine status = new StatusLine();
        DockLayout layout = new DockLayout(preferences, view);
        new Docks(session, looks, view, layout, preferences).arrange(Arrangement.RESEARCHER);
        content.add(layout, BorderLayout.CENTER);
        content.add(status, BorderLayout.SOUTH);
        content.setSize(WIDTH, HEIGHT);
        session.listen(new Session.Events() {
            @Override
            public void onScene(LiveScene scene) {
                status.show(scene);
            }

            @Override
            public void onTick(Status now) {
                status.show(now);
                status.showFrames(view.picturesPerS());
                ticks++;
            }
        });
        // Without a window nobody else does.
        content.addNotify();
        content.validate();
    }

    /**
     * Breathes and paints.
     *
     * @param timeS simulated time of the picture, s
     * @throws NoGraphicsException if nothing here draws the view, or the window's parts cannot be painted, with one sentence
     */
    public static FigurePicture of(Scenario scenario, double timeS) throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        WindowPicture[] made = new WindowPicture[1];
        try {
            onEdt(() -> {
                Theme.install(false);
                made[0] = new WindowPicture(new Session(scenario));
            });
            return made[0].at(timeS);
        } finally {
            if (made[0] != null) {
                made[0].view.close();
                made[0].session.close();
            }
        }
    }

    private FigurePicture at(double timeS) throws NoGraphicsException {
        await(() -> view.isImpossible() || view.pictures() > 0);
        onEdt(() -> content.shown = true);
        session.live().setSpeed(Speed.FLAT_OUT.factor());
        await(() -> session.live().status().timeS() >= timeS);
        long step = session.live().status().step();
        await(() -> view.isImpossible() || view.shownStep() >= step);
        if (view.isImpossible()) {
            throw new NoGraphicsException("The view of the window could not be drawn here");
        }
        int before = ticks;
        await(() -> ticks > before + 1);
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        onEdt(() -> {
            content.validate();
            Graphics2D g = image.createGraphics();
            content.paint(g);
            g.dispose();
        });
        return new FigurePicture(
                "fig2-interface",
                "The window: organs to choose at the left, the breathing thorax in the middle, parameters with sliders at the"
                        + " right, plots and timeline below",
                "",
                image);
    }

    /** Holds the parts. While they are being laid out it is not showing, or text fields would ask where on the screen they are; then it is, or plots would save themselves the work. */
    private static final class OffScreen extends JPanel {
        private boolean shown;

        OffScreen() {
            super(new BorderLayout());
        }

        @Override
        public boolean isShowing() {
            return shown;
        }
    }

    private interface Condition {
        boolean holds();
    }

    private static void await(Condition condition) throws NoGraphicsException {
        long end = System.currentTimeMillis() + PATIENCE_MS;
        boolean[] holds = new boolean[1];
        while (true) {
            onEdt(() -> holds[0] = condition.holds());
            if (holds[0]) {
                return;
            }
            if (System.currentTimeMillis() > end) {
                throw new NoGraphicsException(
                        "The window could not be painted here within " + PATIENCE_MS / 1000 + " s");
            }
            try {
                Thread.sleep(LOOK_MS);
            } catch (InterruptedException stopped) {
                Thread.currentThread().interrupt();
                throw new NoGraphicsException("The window was not painted: it was interrupted", stopped);
            }
        }
    }

    private static void onEdt(Runnable what) throws NoGraphicsException {
        try {
            SwingUtilities.invokeAndWait(what);
        } catch (InvocationTargetException e) {
            String reason = Optional.ofNullable(e.getCause().getMessage())
                    .orElse(e.getCause().toString());
            throw new NoGraphicsException("The window's parts cannot be painted here: " + reason, e.getCause());
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new NoGraphicsException("The window was not painted: it was interrupted", stopped);
        }
    }
}
