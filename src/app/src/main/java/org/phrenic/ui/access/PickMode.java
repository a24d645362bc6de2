package org.phrenic.ui.access;

import java.awt.Cursor;
import java.util.Optional;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.SceneViewport;

/** What the next click in the view chooses. On the event dispatch thread. */
public final class PickMode {
    /** What may be chosen. */
    public enum Kind {
        NONE,
        ENTRY,
        TARGET
    }

    private final Session session;
    private final RehearsalController rehearsal;
    private final SceneViewport view;
    private Kind mode = Kind.NONE;

    PickMode(Session session, RehearsalController rehearsal, SceneViewport view) {
        this.session = session;
        this.rehearsal = rehearsal;
        this.view = view;
    }

    /** The next click chooses; nothing if it is pressed again. */
    public void toggle(Kind what) {
        mode = what == mode || rehearsal.stage() != RehearsalStage.READY ? Kind.NONE : what;
        if (mode == Kind.TARGET && rehearsal.exercise().isPresent()) {
            mode = Kind.NONE;
            session.note("The exercise sets the target; choose Practice for one of your own.");
        }
        view.setCursor(Cursor.getPredefinedCursor(mode == Kind.NONE ? Cursor.DEFAULT_CURSOR : Cursor.CROSSHAIR_CURSOR));
        rehearsal.fireState();
    }

    public Kind mode() {
        return mode;
    }

    /** What was clicked on while something was being chosen. */
    void picked(Optional<PickResult> pick) {
        Kind what = mode;
        toggle(Kind.NONE);
        if (pick.isEmpty()) {
            session.note(
                    what == Kind.ENTRY ? "Click on the skin for the entry." : "Click on the liver for the target.");
        } else if (what == Kind.ENTRY) {
            rehearsal.entrySelection().select(pick.get().restPosition());
        } else {
            rehearsal.setTargetBehind(pick.get());
        }
    }
}
