package org.phrenic.ui;

import java.awt.Cursor;
import java.util.Optional;
import org.phrenic.scene.Pick;

/** What the next click in the view chooses. On the event dispatch thread. */
final class ClickChoice {
    /** What may be chosen. */
    enum Of {
        NOTHING,
        ENTRY,
        TARGET
    }

    private final Session session;
    private final RehearsalDoor door;
    private final SceneView view;
    private Of choosing = Of.NOTHING;

    ClickChoice(Session session, RehearsalDoor door, SceneView view) {
        this.session = session;
        this.door = door;
        this.view = view;
    }

    /** The next click chooses; nothing if it is pressed again. */
    void choose(Of what) {
        choosing = what == choosing || door.stage() != DoorStage.READY ? Of.NOTHING : what;
        if (choosing == Of.TARGET && door.exercise().isPresent()) {
            choosing = Of.NOTHING;
            session.say(
                    Session.Message.Kind.NOTE, "The exercise sets the target; choose Practice for one of your own.");
        }
        view.setCursor(
                Cursor.getPredefinedCursor(choosing == Of.NOTHING ? Cursor.DEFAULT_CURSOR : Cursor.CROSSHAIR_CURSOR));
        door.tell();
    }

    Of choosing() {
        return choosing;
    }

    /** What was clicked on while something was being chosen. */
    void chosen(Optional<Pick> pick) {
        Of what = choosing;
        choose(Of.NOTHING);
        if (pick.isEmpty()) {
            session.say(
                    Session.Message.Kind.NOTE,
                    what == Of.ENTRY ? "Click on the skin for the entry." : "Click on the liver for the target.");
        } else if (what == Of.ENTRY) {
            door.way().enterAt(pick.get().rest());
        } else {
            door.targetBehind(pick.get());
        }
    }
}
