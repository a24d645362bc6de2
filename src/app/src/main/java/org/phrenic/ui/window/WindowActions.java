package org.phrenic.ui.window;

import java.util.Optional;
import org.phrenic.scenario.Assignment;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.Session;

/** What commands do to the window. */
final class WindowActions implements MenuActions.Handler {
    private final PhrenicWindow window;

    WindowActions(PhrenicWindow window) {
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
    public void savePicture() {
        window.files().savePicture();
    }

    @Override
    public void copyCommand() {
        new CopyCommandAction(window.session()).actionPerformed(null);
    }

    @Override
    public void toggleDock(DockLayout.Place place) {
        window.docks().toggle(place);
    }

    @Override
    public void toggleTheme() {
        window.toggleTheme();
    }

    @Override
    public void plotPickedPoint() {
        Optional<org.phrenic.scene.camera.PickResult> pick = window.view().picked();
        if (pick.isPresent()) {
            window.docks().plots().trackPoint(pick.get().index(), pick.get().vertex());
            window.session().note("Plotting a point of " + pick.get().displayName() + ".");
        } else {
            window.session().note("Click on a structure first, then plot that point.");
        }
    }

    @Override
    public void showKeys() {
        HelpDialogs.keys(window.frame(), window.commands().all()).setVisible(true);
    }

    @Override
    public void showLog() {
        window.log().showDialog(window.frame());
    }

    @Override
    public void showAbout() {
        HelpDialogs.about(window.frame(), window.view().graphicsInfo()).setVisible(true);
    }

    @Override
    public void quit() {
        window.close();
    }

    @Override
    public void toggleHold() {
        Session session = window.session();
        boolean on = !session.scenario().hold();
        if (door().isActive()) {
            door().needle().toggleHold();
        } else {
            session.change(
                    on ? "Hold of the breath" : "End of the hold",
                    new Assignment("window", "hold", String.valueOf(on)));
        }
    }

    @Override
    public void restart() {
        if (door().isActive()) {
            door().retry();
        } else {
            window.session().live().reset();
        }
    }

    @Override
    public RehearsalController door() {
        return window.docks().rehearsalController();
    }

    @Override
    public void selectPreset(String preset) {
        window.docks().breath().selectPreset(preset);
    }
}
