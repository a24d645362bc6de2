package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.function.BooleanSupplier;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;
import java.util.stream.Stream;
import javax.accessibility.Accessible;
import javax.imageio.ImageIO;
import javax.swing.JDialog;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;

/**
 * A window under test: opened with preferences of its own, driven through its controls, watched through its
 * observables.
 */
public final class WindowHarness implements AutoCloseable {
    /** The coarse sheet alone, which breathes as the whole scene does, and quickly. */
    public static final Scenario COARSE_SHEET = Scenario.defaults()
            .with(
                    "resolution=low",
                    "mesh_vertices=3000",
                    "lungs=embedded",
                    "sternum=kinematic",
                    "liver=false",
                    "rate_per_min=40");

    private static final long PATIENCE_MS = 60_000;
    /** Time in which the view of a scene at rest becomes sharp. */
    private static final long SHARPENED_MS = 1500;

    private static final Path PICTURES = Path.of("target", "screenshots");

    private final Preferences node;
    private final Watch watch = new Watch();
    private final PhrenicWindow window;

    public WindowHarness(String name, Scenario scenario) throws Exception {
        node = Preferences.userRoot().node("org/phrenic/test-" + name);
        node.clear();
        Session session = new Session(scenario);
        window = onEdt(() -> {
            PhrenicWindow made = new PhrenicWindow(new WindowPreferences(node), session);
            made.show();
            return made;
        });
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(watch);
        await(
                "a first picture",
                () -> window.view().frameCount() > 0 || window.view().isUnavailable());
        await("a scene", () -> onEdt(() -> window.session().scene().isPresent()));
    }

    public PhrenicWindow window() {
        return window;
    }

    public Session session() {
        return window.session();
    }

    /** Ends a test, and says so, where no window can be shown. */
    public static void assumeDisplay() {
        assertThat(WindowStart.obstacle().isEmpty()
                        || System.getenv("DISPLAY") == null
                        || !Boolean.getBoolean("java.awt.headless"))
                .as("a display is there, but an earlier test of this process has made it headless")
                .isTrue();
        assumeThat(WindowStart.obstacle().isEmpty())
                .as("no display here: the window is not tested (start Xvfb and set DISPLAY)")
                .isTrue();
    }

    public static <T> T onEdt(Callable<T> what) {
        try {
            if (EventQueue.isDispatchThread()) {
                return what.call();
            }
            FutureTask<T> task = new FutureTask<>(what);
            SwingUtilities.invokeLater(task);
            return task.get();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    public static void doOnEdt(Runnable what) {
        onEdt(() -> {
            what.run();
            return null;
        });
    }

    /** Waits until something holds. */
    public static void await(String what, BooleanSupplier holds) throws InterruptedException {
        long end = System.currentTimeMillis() + PATIENCE_MS;
        while (!holds.getAsBoolean()) {
            assertThat(System.currentTimeMillis()).as("waiting for " + what).isLessThan(end);
            Thread.sleep(10);
        }
    }

    /** Waits until the simulation has gone on by so much simulated time. */
    public void breathe(double seconds) throws InterruptedException {
        double until = session().live().status().timeS() + seconds;
        await("simulated time", () -> session().live().status().timeS() >= until);
    }

    /** Newest value of an observable. */
    double observed(String column) {
        RunHistory history = session().live().history();
        return history.values(history.size() - 1)[Observation.COLUMNS.indexOf(column)];
    }

    /** Lowest value of an observable after a time of the history. */
    double lowest(String column, double sinceS) {
        RunHistory history = session().live().history();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < history.size(); i++) {
            if (history.time(i) >= sinceS) {
                least = Math.min(least, history.values(i)[Observation.COLUMNS.indexOf(column)]);
            }
        }
        return least;
    }

    double nowS() {
        return session().live().status().timeS();
    }

    /** Value of a key as it is set now. */
    Object set(String key) {
        return onEdt(() -> session().scenario().toMap().get(key));
    }

    /** The control of this accessible name and kind. */
    public <C extends Component> C control(Class<C> kind, String accessibleName) {
        return onEdt(() -> find(window.frame().getRootPane(), kind, accessibleName)
                .orElseThrow(() -> new AssertionError("no " + kind.getSimpleName() + " named " + accessibleName)));
    }

    /** The dialog of this name that is shown. */
    public static Optional<JDialog> dialog(String name) {
        return Stream.of(Window.getWindows())
                .filter(window -> window.isVisible() && name.equals(window.getName()))
                .map(JDialog.class::cast)
                .findFirst();
    }

    /** The first control of this kind and accessible name in a part of a window. */
    public static <C extends Component> Optional<C> find(Component at, Class<C> kind, String name) {
        if (kind.isInstance(at)
                && at instanceof Accessible accessible
                && accessible.getAccessibleContext() != null
                && name.equals(accessible.getAccessibleContext().getAccessibleName())) {
            return Optional.of(kind.cast(at));
        }
        if (at instanceof Container container) {
            for (Component child : container.getComponents()) {
                Optional<C> found = find(child, kind, name);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    /** Everything in the window that takes part in the keyboard's tour. */
    public List<Component> controls() {
        return onEdt(() -> {
            List<Component> list = new ArrayList<>();
            collect(window.frame().getRootPane(), list);
            return list;
        });
    }

    private static void collect(Component at, List<Component> list) {
        if (at instanceof javax.swing.AbstractButton
                || at instanceof javax.swing.JSlider
                || at instanceof javax.swing.JComboBox
                || at instanceof javax.swing.JTextField) {
            if (at.isFocusable()) {
                list.add(at);
            }
        } else if (at instanceof Container container) {
            for (Component child : container.getComponents()) {
                collect(child, list);
            }
        }
    }

    /** Does what a command of the menus does. */
    public void command(String name) {
        doOnEdt(() -> window.commands().all().stream()
                .filter(command -> command.name().equals(name))
                .findFirst()
                .orElseThrow()
                .actionPerformed(null));
    }

    /** Presses and releases a key, as {@link KeyStroke#getKeyStroke(String)} names it, with the view in focus. */
    public void key(String name) {
        press(window.view(), KeyStroke.getKeyStroke(name));
    }

    /** Presses and releases a key with a part in focus. */
    public static void press(Component part, KeyStroke stroke) {
        doOnEdt(() -> {
            for (int id : new int[] {KeyEvent.KEY_PRESSED, KeyEvent.KEY_RELEASED}) {
                // A display without a window manager gives no window the focus, so the event is led to the part by
                // hand.
                KeyboardFocusManager.getCurrentKeyboardFocusManager()
                        .redispatchEvent(
                                part,
                                new KeyEvent(
                                        part,
                                        id,
                                        System.currentTimeMillis(),
                                        stroke.getModifiers(),
                                        stroke.getKeyCode(),
                                        KeyEvent.CHAR_UNDEFINED));
            }
        });
    }

    /**
     * Presses, releases and clicks the left button at a place of a part, by way of the window: what lies above gets it.
     */
    public void click(Component part, double x, double y) {
        mouse(
                part,
                x,
                y,
                MouseEvent.MOUSE_MOVED,
                MouseEvent.MOUSE_PRESSED,
                MouseEvent.MOUSE_RELEASED,
                MouseEvent.MOUSE_CLICKED);
    }

    /** Clicks in the middle of a part. */
    public void click(Component part) {
        click(part, part.getWidth() / 2.0, part.getHeight() / 2.0);
    }

    /** Sends mouse events of the left button at a place of a part, by way of the window. */
    public void mouse(Component part, double x, double y, int... ids) {
        doOnEdt(() -> {
            Point at = SwingUtilities.convertPoint(part, (int) Math.round(x), (int) Math.round(y), window.frame());
            for (int id : ids) {
                boolean down = id == MouseEvent.MOUSE_PRESSED || id == MouseEvent.MOUSE_DRAGGED;
                window.frame()
                        .dispatchEvent(new MouseEvent(
                                window.frame(),
                                id,
                                System.currentTimeMillis(),
                                down ? InputEvent.BUTTON1_DOWN_MASK : 0,
                                at.x,
                                at.y,
                                id == MouseEvent.MOUSE_MOVED ? 0 : 1,
                                false,
                                id == MouseEvent.MOUSE_MOVED || id == MouseEvent.MOUSE_DRAGGED
                                        ? MouseEvent.NOBUTTON
                                        : MouseEvent.BUTTON1));
            }
        });
    }

    /** Turns the wheel over the middle of a part; away from the user is negative. */
    public void wheel(Component part, int notches) {
        wheel(part, notches, 0);
    }

    /** @param modifiers keys held meanwhile, such as {@link java.awt.event.InputEvent#SHIFT_DOWN_MASK} */
    public void wheel(Component part, int notches, int modifiers) {
        doOnEdt(() -> {
            Point at = SwingUtilities.convertPoint(part, part.getWidth() / 2, part.getHeight() / 2, window.frame());
            window.frame()
                    .dispatchEvent(new MouseWheelEvent(
                            window.frame(),
                            MouseEvent.MOUSE_WHEEL,
                            System.currentTimeMillis(),
                            modifiers,
                            at.x,
                            at.y,
                            0,
                            false,
                            MouseWheelEvent.WHEEL_UNIT_SCROLL,
                            3,
                            notches));
        });
    }

    /** Paints the window into a picture that can be looked at afterwards. */
    public BufferedImage screenshot(String name) throws IOException {
        BufferedImage picture = painted(window);
        Files.createDirectories(PICTURES);
        ImageIO.write(picture, "png", PICTURES.resolve(name + ".png").toFile());
        return picture;
    }

    private static BufferedImage painted(PhrenicWindow window) {
        return onEdt(() -> {
            BufferedImage image = new BufferedImage(
                    window.frame().getRootPane().getWidth(),
                    window.frame().getRootPane().getHeight(),
                    BufferedImage.TYPE_INT_RGB);
            window.frame().getRootPane().paint(image.createGraphics());
            return image;
        });
    }

    /** Writes a picture of a window whose scene rests meanwhile, so that a view that the processor draws is sharp. */
    public static void writeAtRest(PhrenicWindow window, Path file) throws IOException, InterruptedException {
        EventThread.run(window.session()::togglePlay);
        Thread.sleep(SHARPENED_MS);
        ImageIO.write(painted(window), "png", file.toFile());
        EventThread.run(window.session()::togglePlay);
    }

    /** Times that events took on the event dispatch thread since the window was there, ms, longest last. */
    public List<Double> dispatches() {
        synchronized (watch.tookMs) {
            List<Double> sorted = new ArrayList<>(watch.tookMs);
            Collections.sort(sorted);
            return sorted;
        }
    }

    public void forgetDispatches() {
        synchronized (watch.tookMs) {
            watch.tookMs.clear();
        }
    }

    @Override
    public void close() throws BackingStoreException {
        watch.end();
        doOnEdt(window::close);
        node.removeNode();
    }

    /**
     * Measures how long each event keeps the event dispatch thread, in processor time so that other processes do not
     * count.
     */
    private static final class Watch extends EventQueue {
        private final List<Double> tookMs = new ArrayList<>();
        private final java.lang.management.ThreadMXBean threads = ManagementFactory.getThreadMXBean();

        @Override
        protected void dispatchEvent(AWTEvent event) {
            long begun = threads.getCurrentThreadCpuTime();
            super.dispatchEvent(event);
            double took = (threads.getCurrentThreadCpuTime() - begun) * 1e-6;
            synchronized (tookMs) {
                tookMs.add(took);
            }
        }

        void end() {
            pop();
        }
    }
}
