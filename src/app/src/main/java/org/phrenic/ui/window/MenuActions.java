package org.phrenic.ui.window;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.ui.access.NeedleController;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Icons;

/** All actions of the window: menus, tool bar, accelerators and the table of keys are made from them. */
final class MenuActions {
    private static final double NEEDLE_STEP_MM = 2;
    private static final double NEEDLE_LONG_STEP_MM = 10;
    private static final double TURN_DEG = 1;
    private static final double SLIDE_MM = 2;
    private static final double TILT_DEG = 2;
    private static final double ROTATE_DEG = 5;
    private static final double ORBIT_DEG = 5;
    private static final double PAN_PIXELS = 24;
    private static final double ZOOM = 1.15;

    final MenuAction play;
    final MenuAction step;
    final MenuAction reset;
    final MenuAction quiet;
    final MenuAction deep;
    final MenuAction hold;
    final MenuAction picture;
    final MenuAction theme;
    final MenuAction undo;
    final MenuAction redo;
    final MenuAction open;
    final MenuAction importScan;
    final MenuAction save;
    final MenuAction copy;
    final MenuAction quit;
    final List<MenuAction> views = new ArrayList<>();
    final List<MenuAction> camera = new ArrayList<>();
    final List<MenuAction> needle = new ArrayList<>();
    final List<MenuAction> probe = new ArrayList<>();
    final List<MenuAction> docks = new ArrayList<>();
    final List<MenuAction> help;

    private final PhrenicWindow window;
    /** The table of keys, of which there is one; null before it is first shown. */
    private JDialog keys;

    private JDialog about;

    MenuActions(PhrenicWindow window) {
        this.window = window;
        Session session = window.session();
        WindowFiles files = window.files();
        open = action("Open...", "Open a scenario, a thorax folder or a trace", "menu O", files::chooseAndOpen);
        importScan = action("Import scan...", "Make a body of the labels of a scan", "menu I", files::chooseAndImport);
        save = action("Save scenario...", "Save the present values as a scenario", "menu S", window::saveScenario);
        picture = action("Save picture...", "Save the view as a PNG file", "F12", files::savePicture)
                .withIcon(Icons.CAMERA);
        copy = action(
                "Copy as command",
                "Copy the command line that repeats this run without a window",
                "menu C",
                () -> new CopyCommandAction(session).actionPerformed(null));
        quit = action("Quit", "Close the window", "menu Q", window::quit);
        undo = action("Undo", "Undo the last change", "menu Z", () -> edit("Undo", session.edits()::undo));
        redo = action("Redo", "Redo the change undone last", "menu shift Z", () -> edit("Redo", session.edits()::redo));
        play = action("Play or pause", "Start or pause breathing", "SPACE", session::togglePlay)
                .withIcon(Icons.PAUSE);
        step = action("One step", "Pause and go on by one time step", "S", session::stepOnce)
                .withIcon(Icons.STEP);
        reset = action("Back to the start", "Restart with the present values", "R", this::restart)
                .withIcon(Icons.RESET);
        quiet = action("Quiet", "Breathe quietly", "Q", () -> selectPreset("quiet"));
        deep = action("Deep", "Breathe deeply", "D", () -> selectPreset("deep"));
        hold = action("Hold", "Hold, or breathe on; rehearsing, at end-expiration", "H", this::toggleHold);
        theme = action("Light or dark", "Change between a light and a dark window", "menu L", window::toggleTheme)
                .withIcon(Icons.THEME);
        addViews(window.view());
        addCameraMoves(window.view());
        addNeedleActions();
        addProbeActions();
        addDock(DockLayout.Place.LEFT, "Organs", "menu 1");
        addDock(DockLayout.Place.RIGHT, "Controls", "menu 2");
        addDock(DockLayout.Place.BOTTOM, "Plots and timeline", "menu 3");
        help = List.of(
                action("Keys", "All keys, and what the mouse does", "F1", this::showKeys),
                action("Log", "Messages since the window opened", "menu shift L", () -> window.log()
                        .showDialog(window.frame())),
                action("About Phrenic", "Version, citation, licences", null, this::showAbout));
    }

    private static MenuAction action(String name, String tip, String key, Runnable operation) {
        return new MenuAction(name, tip, key, operation);
    }

    private void addViews(SceneViewport view) {
        addView(AnatomicalView.ANTERIOR, "From the front", "1");
        addView(AnatomicalView.POSTERIOR, "From behind", "shift 1");
        addView(AnatomicalView.LEFT, "From the left", "3");
        addView(AnatomicalView.RIGHT, "From the right", "shift 3");
        addView(AnatomicalView.SUPERIOR, "From above", "7");
        addView(AnatomicalView.INFERIOR, "From below", "shift 7");
        views.add(action(
                "Parallel or perspective",
                "Parallel projection has a ruler; perspective has depth",
                "5",
                () -> view.setCamera(view.camera().withProjection(!view.camera().orthographic()))));
        views.add(action("Whole thorax", "The initial view", "0", view::resetCamera));
        views.add(action("Plot this point", "Plot how the point last clicked moves", "P", this::plotPickedPoint));
    }

    private void addCameraMoves(SceneViewport view) {
        String[] directions = {"Left", "Right", "Up", "Down"};
        for (int i = 0; i < directions.length; i++) {
            int x = i < 2 ? 2 * i - 1 : 0;
            int y = i < 2 ? 0 : 2 * i - 5;
            String where = directions[i].toLowerCase(Locale.ROOT);
            String key = directions[i].toUpperCase(Locale.ROOT);
            addCameraMove(
                    view,
                    "Turn view " + where,
                    "Turn what is seen, as dragging " + where + " does",
                    "alt " + key,
                    c -> c.orbit(-ORBIT_DEG * x, ORBIT_DEG * y));
            addCameraMove(
                    view,
                    "Move view " + where,
                    "Move what is seen " + where,
                    "alt shift " + key,
                    c -> c.pan(PAN_PIXELS * x, PAN_PIXELS * y, view.getHeight()));
        }
        addCameraMove(view, "Enlarge", "Enlarge the middle of the view", "PLUS", c -> zoomed(c, ZOOM));
        addCameraMove(view, "Reduce", "Show more about the middle of the view", "MINUS", c -> zoomed(c, 1 / ZOOM));
    }

    private Camera zoomed(Camera camera, double factor) {
        int width = window.view().getWidth();
        int height = window.view().getHeight();
        return camera.zoom(factor, width / 2.0, height / 2.0, width, height);
    }

    private void addCameraMove(SceneViewport view, String name, String tip, String key, UnaryOperator<Camera> move) {
        camera.add(action(name, tip, key, () -> view.setCamera(move.apply(view.camera()))));
    }

    private void addView(AnatomicalView from, String name, String key) {
        SceneViewport view = window.view();
        views.add(action(
                name,
                "The " + from.label() + " view",
                key,
                () -> view.setCamera(view.camera().withView(from))));
    }

    private void addNeedleActions() {
        addAccess(
                "Set target", "Then click on the liver", "T", r -> r.pickMode().toggle(PickMode.Kind.TARGET));
        addAccess("Set entry", "Then click on the skin", "E", r -> r.pickMode().toggle(PickMode.Kind.ENTRY));
        addAccess("Best entry", "The best of the map, the needle upright there: aim it", "B", r -> r.entrySelection()
                .selectBest(false));
        addNeedle("Insert", "2 mm deeper; with Shift 10 mm", "I", n -> n.moveBy(NEEDLE_STEP_MM));
        addNeedle("Insert far", "10 mm deeper", "shift I", n -> n.moveBy(NEEDLE_LONG_STEP_MM));
        addNeedle("Withdraw", "2 mm back; with Shift 10 mm", "W", n -> n.moveBy(-NEEDLE_STEP_MM));
        addNeedle("Withdraw far", "10 mm back", "shift W", n -> n.moveBy(-NEEDLE_LONG_STEP_MM));
        addNeedle("Go to target", "To where it passes nearest to the target", "G", NeedleController::moveToTarget);
        addNeedle(
                "Aim for me",
                "The program points the needle at the target; the report says so",
                "A",
                NeedleController::aimAtTarget);
        addNeedle("Take sample", "Where the tip is", "X", NeedleController::takeSample);
        addNeedle("Take out", "Withdraw the needle all the way", "O", n -> n.moveTo(0));
        addTurns();
        addNeedle("Look along the needle", "The view from the hub towards the tip", "N", NeedleController::lookAlong);
    }

    private void addTurns() {
        String degrees = "1 degree; the needle turns about its point on the skin";
        addNeedle("Turn to the patient's left", degrees, "RIGHT", n -> n.turnBy(TURN_DEG, 0));
        addNeedle("Turn to the patient's right", degrees, "LEFT", n -> n.turnBy(-TURN_DEG, 0));
        addNeedle("Turn to the head", degrees, "UP", n -> n.turnBy(0, TURN_DEG));
        addNeedle("Turn to the feet", degrees, "DOWN", n -> n.turnBy(0, -TURN_DEG));
    }

    private void addProbeActions() {
        addProbe("Put probe", "Then click on the skin", "U", r -> r.pickMode().toggle(PickMode.Kind.PROBE));
        addProbe("Lift probe", "Take the probe off the skin", "shift U", r -> r.probe()
                .lift());
        addProbe("Needle in plane", "Entry beside the probe, in the image plane", "K", r -> r.probe()
                .enterBeside());
        addProbe("Slide to the marker", "2 mm", "shift LEFT", r -> r.probe().slide(SLIDE_MM, 0));
        addProbe("Slide from the marker", "2 mm", "shift RIGHT", r -> r.probe().slide(-SLIDE_MM, 0));
        addProbe("Slide out of the plane", "2 mm", "shift UP", r -> r.probe().slide(0, SLIDE_MM));
        addProbe("Slide back through the plane", "2 mm", "shift DOWN", r -> r.probe()
                .slide(0, -SLIDE_MM));
        addProbe("Tilt forward", "2 degrees, out of the image plane", "menu UP", r -> r.probe()
                .turn(0, TILT_DEG, 0));
        addProbe("Tilt back", "2 degrees", "menu DOWN", r -> r.probe().turn(0, -TILT_DEG, 0));
        addProbe("Rock to the marker", "2 degrees", "menu LEFT", r -> r.probe().turn(0, 0, TILT_DEG));
        addProbe("Rock from the marker", "2 degrees", "menu RIGHT", r -> r.probe()
                .turn(0, 0, -TILT_DEG));
        addProbe("Rotate anticlockwise", "5 degrees, as seen from outside", "COMMA", r -> r.probe()
                .turn(ROTATE_DEG, 0, 0));
        addProbe("Rotate clockwise", "5 degrees", "PERIOD", r -> r.probe().turn(-ROTATE_DEG, 0, 0));
    }

    /** Lets keys act on needle and probe from the parts of the window. */
    NeedleKeys needleKeys() {
        return new NeedleKeys(Stream.concat(needle.stream(), probe.stream()).toList(), window.view());
    }

    /** Enables what does something in a workspace. */
    void setWorkspace(Workspace workspace) {
        boolean clinician = workspace == Workspace.CLINICIAN;
        needle.forEach(action -> action.setEnabled(clinician));
        probe.forEach(action -> action.setEnabled(clinician));
        docks.get(DockLayout.Place.BOTTOM.ordinal()).setEnabled(!clinician);
    }

    private void addProbe(String name, String tip, String key, Consumer<RehearsalController> operation) {
        probe.add(action(name, tip, key, () -> operation.accept(rehearsal())));
    }

    private void addNeedle(String name, String tip, String key, Consumer<NeedleController> operation) {
        addAccess(name, tip, key, rehearsal -> operation.accept(rehearsal.needle()));
    }

    private void addAccess(String name, String tip, String key, Consumer<RehearsalController> operation) {
        needle.add(action(name, tip, key, () -> operation.accept(rehearsal())));
    }

    private void addDock(DockLayout.Place place, String name, String key) {
        String tip = "Show or hide: " + name.toLowerCase(Locale.ROOT);
        docks.add(action(name, tip, key, () -> window.docks().toggle(place))
                .withState(() -> window.docks().isShown(place)));
    }

    private RehearsalController rehearsal() {
        return window.docks().rehearsalController();
    }

    private void showKeys() {
        if (keys == null) {
            keys = HelpDialogs.keys(window.frame(), all());
        }
        keys.setVisible(true);
        keys.toFront();
    }

    private void showAbout() {
        if (about == null || !about.isVisible()) {
            about = HelpDialogs.about(window.frame(), window.view().graphicsInfo());
        }
        about.setVisible(true);
        about.toFront();
    }

    private void selectPreset(String preset) {
        window.docks().selectPreset(preset);
    }

    private void edit(String name, Runnable undoOrRedo) {
        rehearsal().needle().unlessInBody(name, undoOrRedo);
    }

    private void restart() {
        window.session().returnToLive();
        if (rehearsal().stage().ownsBreath()) {
            rehearsal().retry();
        } else {
            window.session().live().reset();
        }
    }

    /** Whether the breath is held, or will be. */
    boolean isBreathHeld() {
        return rehearsal().needle().isBreathHeld();
    }

    private void toggleHold() {
        Session session = window.session();
        boolean on = !session.scenario().hold();
        if (rehearsal().stage().ownsBreath()) {
            rehearsal().needle().toggleHold();
        } else {
            session.change(on ? "Hold of the breath" : "End of the hold", Assignment.of("window", Breathing.HOLD, on));
        }
    }

    private void plotPickedPoint() {
        Optional<String> follows = window.view().picked().flatMap(p -> window.docks()
                .plots()
                .trackPoint(p.index(), p.vertex())
                .map(point -> point + " of the plot follows " + p.displayName() + "."));
        window.session().note(follows.orElse("Click on a structure first, then plot that point."));
    }

    /**
     * Lets the digits, plus and minus of the numeric keypad do what those of the keyboard do, and the key that has the
     * plus beside the equals sign what plus does.
     */
    void bindNumericKeypad(JRootPane root) {
        bind(root, KeyStroke.getKeyStroke("ADD"), cameraMove("Enlarge"));
        bind(root, KeyStroke.getKeyStroke("EQUALS"), cameraMove("Enlarge"));
        bind(root, KeyStroke.getKeyStroke("shift EQUALS"), cameraMove("Enlarge"));
        bind(root, KeyStroke.getKeyStroke("SUBTRACT"), cameraMove("Reduce"));
        for (MenuAction action : views) {
            KeyStroke key = action.accelerator();
            if (key != null && key.getKeyCode() >= KeyEvent.VK_0 && key.getKeyCode() <= KeyEvent.VK_9) {
                int keypad = KeyEvent.VK_NUMPAD0 + key.getKeyCode() - KeyEvent.VK_0;
                bind(root, KeyStroke.getKeyStroke(keypad, key.getModifiers()), action);
            }
        }
    }

    private MenuAction cameraMove(String name) {
        return camera.stream().filter(a -> a.name().equals(name)).findFirst().orElseThrow();
    }

    private static void bind(JRootPane root, KeyStroke key, MenuAction action) {
        root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(key, action.name());
        root.getActionMap().put(action.name(), action);
    }

    /** All of them, in the order of the menus. */
    List<MenuAction> all() {
        List<MenuAction> first =
                List.of(open, importScan, save, picture, copy, quit, undo, redo, play, step, reset, quiet, deep, hold);
        return Stream.of(first, needle, probe, views, camera, docks, List.of(theme), help)
                .flatMap(List::stream)
                .toList();
    }
}
