package org.phrenic.ui;

import java.util.Optional;
import org.phrenic.simulation.Assignment;

/** What commands do to the window. */
final class WindowDesk implements Commands.Desk {
    private final PhrenicWindow window;

    WindowDesk(PhrenicWindow window) {
        this.window = window;
    }

    @Override
    public void open() {
        window.files().chooseAndOpen();
    }

    @Override
    public void save() {
        window.files().saveScenario();
    }

    @Override
    public void picture() {
        window.files().savePicture();
    }

    @Override
    public void copyCommand() {
        new CopyCommandAction(window.session()).actionPerformed(null);
    }

    @Override
    public void toggle(DockLayout.Place place) {
        window.docks().toggle(place);
    }

    @Override
    public void toggleTheme() {
        window.toggleTheme();
    }

    @Override
    public void plotPicked() {
        Optional<org.phrenic.scene.Pick> pick = window.view().picked();
        if (pick.isPresent()) {
            window.docks().plots().track(pick.get().index(), pick.get().vertex());
            window.session()
                    .say(
                            Session.Message.Kind.NOTE,
                            "Plotting a point of " + pick.get().name() + ".");
        } else {
            window.session().say(Session.Message.Kind.NOTE, "Click on a structure first, then plot that point.");
        }
    }

    @Override
    public void keys() {
        Dialogs.keys(window.frame(), window.commands().all()).setVisible(true);
    }

    @Override
    public void log() {
        window.log().open(window.frame());
    }

    @Override
    public void about() {
        Dialogs.about(window.frame(), window.view().graphics()).setVisible(true);
    }

    @Override
    public void quit() {
        window.close();
    }

    @Override
    public void hold() {
        Session session = window.session();
        boolean on = !session.scenario().hold();
        if (door().isOpen()) {
            door().hand().toggleHold();
        } else {
            session.change(
                    on ? "Hold of the breath" : "End of the hold",
                    new Assignment("window", "hold", String.valueOf(on)));
        }
    }

    @Override
    public void back() {
        if (door().isOpen()) {
            door().retry();
        } else {
            window.session().live().reset();
        }
    }

    @Override
    public RehearsalDoor door() {
        return window.docks().door();
    }

    @Override
    public void breathe(String preset) {
        window.docks().breath().choose(preset);
    }
}
