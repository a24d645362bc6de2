package org.phrenic.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.phrenic.scene.View;

/** Everything that can be done from the menus: the one table from which menus, toolbar, keys and the table of keys are made. */
final class Commands {
    private static final double STEP_MM = 2;
    private static final double FAR_MM = 10;

    /** What commands need of the window. */
    interface Desk {
        void open();

        void save();

        void picture();

        void copyCommand();

        void toggle(DockLayout.Place place);

        void toggleTheme();

        void plotPicked();

        void keys();

        void log();

        void about();

        void quit();

        void breathe(String preset);

        void hold();

        void back();

        RehearsalDoor door();
    }

    final Command play;
    final Command step;
    final Command reset;
    final Command quiet;
    final Command deep;
    final Command hold;
    final Command picture;
    final Command theme;
    final Command undo;
    final Command redo;
    final Command open;
    final Command save;
    final Command copy;
    final Command quit;
    final List<Command> views = new ArrayList<>();
    final List<Command> needle = new ArrayList<>();
    final List<Command> docks = new ArrayList<>();
    final List<Command> help = new ArrayList<>();

    Commands(Session session, SceneView view, Desk desk) {
        open = new Command("Open...", "Open a scenario, a thorax folder or a trace", "menu O", desk::open);
        save = new Command("Save scenario...", "Save what is set now as a scenario", "menu S", desk::save);
        picture = new Command("Save picture...", "Save the view as a PNG file", "F12", desk::picture)
                .withIcon(Icons.CAMERA);
        copy = new Command(
                "Copy as command",
                "Copy the command line that repeats this run without a window",
                "menu C",
                desk::copyCommand);
        quit = new Command("Quit", "Close the window", "menu Q", desk::quit);
        undo = new Command("Undo", "Take back the last change", "menu Z", () -> session.edits()
                .undo());
        redo = new Command("Redo", "Do again what was taken back", "menu shift Z", () -> session.edits()
                .redo());
        play = new Command("Play or pause", "Let it breathe, or stop", "SPACE", session::togglePlay)
                .withIcon(Icons.PAUSE);
        step = new Command("One step", "Stop and go on by one time step", "S", () -> {
                    session.live().pause();
                    session.follow();
                    session.live().stepOnce();
                })
                .withIcon(Icons.STEP);
        reset = new Command("Back to the start", "Begin anew with what is set now", "R", () -> {
                    session.follow();
                    desk.back();
                })
                .withIcon(Icons.RESET);
        quiet = new Command("Quiet", "Breathe quietly", "Q", () -> desk.breathe("quiet"));
        deep = new Command("Deep", "Breathe deeply", "D", () -> desk.breathe("deep"));
        hold = new Command("Hold", "Hold the breath where it is, or let it go on", "H", desk::hold);
        theme = new Command("Light or dark", "Change between a light and a dark window", "menu L", desk::toggleTheme)
                .withIcon(Icons.THEME);
        look(view, View.ANTERIOR, "From the front", "1");
        look(view, View.POSTERIOR, "From behind", "shift 1");
        look(view, View.LEFT, "From the left", "3");
        look(view, View.RIGHT, "From the right", "shift 3");
        look(view, View.SUPERIOR, "From above", "7");
        look(view, View.INFERIOR, "From below", "shift 7");
        views.add(new Command(
                "Parallel or perspective",
                "Parallel projection has a ruler; perspective has depth",
                "5",
                () -> view.setCamera(view.camera().withProjection(!view.camera().orthographic()))));
        views.add(new Command("Whole thorax", "The view as it was at first", "0", view::resetCamera));
        views.add(new Command("Plot this point", "Plot how the point last clicked moves", "P", desk::plotPicked));
        needle(desk);
        dock(desk, DockLayout.Place.LEFT, "Organs", "menu 1");
        dock(desk, DockLayout.Place.RIGHT, "Controls", "menu 2");
        dock(desk, DockLayout.Place.BOTTOM, "Plots and timeline", "menu 3");
        help.add(new Command("Keys", "All keys, and what the mouse does", "F1", desk::keys));
        help.add(new Command("Log", "What was said since the window opened", "menu shift L", desk::log));
        help.add(new Command("About Phrenic", "Version, citation, licences", null, desk::about));
    }

    private void look(SceneView view, View from, String name, String key) {
        views.add(new Command(
                name,
                "The " + from.label() + " view",
                key,
                () -> view.setCamera(view.camera().seen(from))));
    }

    private void needle(Desk desk) {
        needle("Set target", "Then click on the liver", "T", () -> desk.door()
                .clicks()
                .choose(ClickChoice.Of.TARGET));
        needle("Set entry", "Then click on the skin", "E", () -> desk.door()
                .clicks()
                .choose(ClickChoice.Of.ENTRY));
        needle("Best path", "The best entry of the access map", "B", () -> desk.door()
                .way()
                .enterAtBest(false));
        needle("Insert", "2 mm deeper; with Shift 10 mm", "I", () -> desk.door()
                .hand()
                .moveBy(STEP_MM));
        needle("Insert far", "10 mm deeper", "shift I", () -> desk.door().hand().moveBy(FAR_MM));
        needle("Withdraw", "2 mm back; with Shift 10 mm", "W", () -> desk.door()
                .hand()
                .moveBy(-STEP_MM));
        needle("Withdraw far", "10 mm back", "shift W", () -> desk.door().hand().moveBy(-FAR_MM));
        needle("Go to target", "As deep as the target lies", "G", () -> desk.door()
                .hand()
                .moveToTarget());
        needle("Aim again", "Point the needle at where the target is now", "A", () -> desk.door()
                .hand()
                .aim());
        needle("Take sample", "Where the tip is", "X", () -> desk.door().hand().sample());
        needle("Take out", "Withdraw the needle all the way", "O", () -> desk.door()
                .hand()
                .moveTo(0));
        needle("Look along the needle", "The view from the hub towards the tip", "N", () -> desk.door()
                .hand()
                .lookAlong());
    }

    private void needle(String name, String tip, String key, Runnable what) {
        needle.add(new Command(name, tip, key, what));
    }

    private void dock(Desk desk, DockLayout.Place place, String name, String key) {
        docks.add(new Command(
                name, "Show or put away: " + name.toLowerCase(java.util.Locale.ROOT), key, () -> desk.toggle(place)));
    }

    /** All of them, in the order of the menus. */
    List<Command> all() {
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
