package org.phrenic.ui.access;

import java.awt.Cursor;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.SceneViewport;

/**
 * The mouse in the view during a rehearsal: a click, or the Enter key for the middle of the view, chooses entry, target
 * or the place of the probe when that is asked for, dragging moves probe and needle, and the wheel moves the needle
 * once an entry is chosen. With Ctrl, or without an entry, the wheel zooms. Used on the event dispatch thread.
 */
public final class PickMode implements SceneViewport.MouseTool {
    /** What a click chooses. */
    public enum Kind {
        NONE,
        ENTRY,
        TARGET,
        PROBE
    }

    private final Session session;
    private final RehearsalController rehearsal;
    private final SceneViewport view;
    private final HandTool hand;
    private Kind mode = Kind.NONE;

    PickMode(Session session, RehearsalController rehearsal, SceneViewport view) {
        this.session = session;
        this.rehearsal = rehearsal;
        this.view = view;
        hand = new HandTool(rehearsal, view);
    }

    /** Sets what the next click chooses; the same again cancels it. */
    public void toggle(Kind what) {
        mode = what == mode || rehearsal.stage() != RehearsalStage.READY ? Kind.NONE : what;
        if (mode == Kind.TARGET && rehearsal.exercise().isPresent()) {
            mode = Kind.NONE;
            session.note("The exercise sets the target; choose Practice for one of your own.");
        }
        view.setCursor(Cursor.getPredefinedCursor(mode == Kind.NONE ? Cursor.DEFAULT_CURSOR : Cursor.CROSSHAIR_CURSOR));
        view.repaint();
        rehearsal.fireState();
    }

    /** The next click chooses nothing. */
    void cancel() {
        if (mode != Kind.NONE) {
            toggle(Kind.NONE);
        }
    }

    public Kind mode() {
        return mode;
    }

    @Override
    public boolean isPicking() {
        return mode != Kind.NONE;
    }

    @Override
    public ToDoubleFunction<Surface> pickOpacity() {
        return mode == Kind.TARGET ? surface -> surface.kind() == StructureKind.LIVER ? 1 : 0 : rehearsal.skinOpacity();
    }

    @Override
    public Consumer<Optional<PickResult>> receiver() {
        Kind clicked = mode;
        return pick -> picked(clicked, pick);
    }

    /** Takes what was clicked for something, unless a click is for something else by now. */
    private void picked(Kind what, Optional<PickResult> pick) {
        if (what == Kind.NONE || what != mode) {
            return;
        }
        toggle(Kind.NONE);
        if (pick.isEmpty()) {
            session.note(
                    switch (what) {
                        case ENTRY -> "Click on the skin for the entry.";
                        case PROBE -> "Click on the skin for the probe.";
                        default -> "Click on the liver for the target.";
                    });
        } else if (what == Kind.ENTRY) {
            rehearsal.entrySelection().select(pick.get().restPosition());
        } else if (what == Kind.PROBE) {
            rehearsal.probe().put(pick.get().restPosition());
        } else {
            rehearsal.preparation.setTargetBehind(pick.get());
        }
    }

    @Override
    public boolean pressed(MouseEvent e) {
        return !isPicking() && hand.pressed(e);
    }

    @Override
    public void dragged(MouseEvent e) {
        hand.dragged(e);
    }

    @Override
    public boolean wheelTurned(MouseWheelEvent e) {
        return !e.isControlDown() && rehearsal.needle().wheelTurned(e);
    }
}
