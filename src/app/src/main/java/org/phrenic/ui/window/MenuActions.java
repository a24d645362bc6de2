package org.phrenic.ui.window;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Icons;

/**
 * Everything that can be done from the menus: the one table from which menus, toolbar, keys and the table of keys are
 * made.
 */
final class MenuActions {
    private static final double NEEDLE_STEP_MM = 2;
    private static final double NEEDLE_LONG_STEP_MM = 10;

    /** What commands need of the window. */
    interface Handler {
        void open();

        void save();

        void savePicture();

        void copyCommand();

        void toggleDock(DockLayout.Place place);

        void toggleTheme();

        void plotPickedPoint();

        void showKeys();

        void showLog();

        void showAbout();

        void quit();

        void selectPreset(String preset);

        void toggleHold();

        void restart();

        RehearsalController door();
    }

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
    final MenuAction save;
    final MenuAction copy;
    final MenuAction quit;
    final List<MenuAction> views = new ArrayList<>();
    final List<MenuAction> needle = new ArrayList<>();
    final List<MenuAction> docks = new ArrayList<>();
    final List<MenuAction> help = new ArrayList<>();

    MenuActions(Session session, SceneViewport view, Handler desk) {
        open = new MenuAction("Open...", "Open a scenario, a thorax folder or a trace", "menu O", desk::open);
        save = new MenuAction("Save scenario...", "Save what is set now as a scenario", "menu S", desk::save);
        picture = new MenuAction("Save picture...", "Save the view as a PNG file", "F12", desk::savePicture)
                .withIcon(Icons.CAMERA);
        copy = new MenuAction(
                "Copy as command",
                "Copy the command line that repeats this run without a window",
                "menu C",
                desk::copyCommand);
        quit = new MenuAction("Quit", "Close the window", "menu Q", desk::quit);
        undo = new MenuAction("Undo", "Take back the last change", "menu Z", () -> session.edits()
                .undo());
        redo = new MenuAction("Redo", "Do again what was taken back", "menu shift Z", () -> session.edits()
                .redo());
        play = new MenuAction("Play or pause", "Let it breathe, or stop", "SPACE", session::togglePlay)
                .withIcon(Icons.PAUSE);
        step = new MenuAction("One step", "Stop and go on by one time step", "S", () -> {
                    session.live().pause();
                    session.returnToLive();
                    session.live().stepOnce();
                })
                .withIcon(Icons.STEP);
        reset = new MenuAction("Back to the start", "Begin anew with what is set now", "R", () -> {
                    session.returnToLive();
                    desk.restart();
                })
                .withIcon(Icons.RESET);
        quiet = new MenuAction("Quiet", "Breathe quietly", "Q", () -> desk.selectPreset("quiet"));
        deep = new MenuAction("Deep", "Breathe deeply", "D", () -> desk.selectPreset("deep"));
        hold = new MenuAction("Hold", "Hold the breath where it is, or let it go on", "H", desk::toggleHold);
        theme = new MenuAction("Light or dark", "Change between a light and a dark window", "menu L", desk::toggleTheme)
                .withIcon(Icons.THEME);
        addView(view, AnatomicalView.ANTERIOR, "From the front", "1");
        addView(view, AnatomicalView.POSTERIOR, "From behind", "shift 1");
        addView(view, AnatomicalView.LEFT, "From the left", "3");
        addView(view, AnatomicalView.RIGHT, "From the right", "shift 3");
        addView(view, AnatomicalView.SUPERIOR, "From above", "7");
        addView(view, AnatomicalView.INFERIOR, "From below", "shift 7");
        views.add(new MenuAction(
                "Parallel or perspective",
                "Parallel projection has a ruler; perspective has depth",
                "5",
                () -> view.setCamera(view.camera().withProjection(!view.camera().orthographic()))));
        views.add(new MenuAction("Whole thorax", "The view as it was at first", "0", view::resetCamera));
        views.add(
                new MenuAction("Plot this point", "Plot how the point last clicked moves", "P", desk::plotPickedPoint));
        needle(desk);
        addDock(desk, DockLayout.Place.LEFT, "Organs", "menu 1");
        addDock(desk, DockLayout.Place.RIGHT, "Controls", "menu 2");
        addDock(desk, DockLayout.Place.BOTTOM, "Plots and timeline", "menu 3");
        help.add(new MenuAction("Keys", "All keys, and what the mouse does", "F1", desk::showKeys));
        help.add(new MenuAction("Log", "What was said since the window opened", "menu shift L", desk::showLog));
        help.add(new MenuAction("About Phrenic", "Version, citation, licences", null, desk::showAbout));
    }

    private void addView(SceneViewport view, AnatomicalView from, String name, String key) {
        views.add(new MenuAction(
                name,
                "The " + from.label() + " view",
                key,
                () -> view.setCamera(view.camera().withView(from))));
    }

    private void needle(Handler desk) {
        needle("Set target", "Then click on the liver", "T", () -> desk.door()
                .pickMode()
                .toggle(PickMode.Kind.TARGET));
        needle("Set entry", "Then click on the skin", "E", () -> desk.door()
                .pickMode()
                .toggle(PickMode.Kind.ENTRY));
        needle("Best path", "The best entry of the access map", "B", () -> desk.door()
                .entrySelection()
                .selectBest(false));
        needle("Insert", "2 mm deeper; with Shift 10 mm", "I", () -> desk.door()
                .needle()
                .moveBy(NEEDLE_STEP_MM));
        needle("Insert far", "10 mm deeper", "shift I", () -> desk.door()
                .needle()
                .moveBy(NEEDLE_LONG_STEP_MM));
        needle("Withdraw", "2 mm back; with Shift 10 mm", "W", () -> desk.door()
                .needle()
                .moveBy(-NEEDLE_STEP_MM));
        needle("Withdraw far", "10 mm back", "shift W", () -> desk.door()
                .needle()
                .moveBy(-NEEDLE_LONG_STEP_MM));
        needle("Go to target", "As deep as the target lies", "G", () -> desk.door()
                .needle()
                .moveToTarget());
        needle("Aim again", "Point the needle at where the target is now", "A", () -> desk.door()
                .needle()
                .aimAtTarget());
        needle("Take sample", "Where the tip is", "X", () -> desk.door()
                .needle()
                .takeSample());
        needle("Take out", "Withdraw the needle all the way", "O", () -> desk.door()
                .needle()
                .moveTo(0));
        needle("Look along the needle", "The view from the hub towards the tip", "N", () -> desk.door()
                .needle()
                .lookAlong());
    }

    private void needle(String name, String tip, String key, Runnable what) {
        needle.add(new MenuAction(name, tip, key, what));
    }

    private void addDock(Handler desk, DockLayout.Place place, String name, String key) {
        docks.add(new MenuAction(
                name,
                "Show or put away: " + name.toLowerCase(java.util.Locale.ROOT),
                key,
                () -> desk.toggleDock(place)));
    }

    /** All of them, in the order of the menus. */
    List<MenuAction> all() {
        return Stream.of(
                        List.of(open, save, picture, copy, quit, undo, redo, play, step, reset, quiet, deep, hold),
                        needle,
                        views,
                        docks,
                        List.of(theme),
                        help)
                .flatMap(List::stream)
                .toList();
    }
}
