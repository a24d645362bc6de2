package org.phrenic.ui.access;

import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.camera.PickResult;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.view.SceneViewport;

/**
 * The mouse in the view while liver access is rehearsed: a click chooses entry or target when that is asked for, and
 * the wheel moves the needle once an entry is chosen; with Ctrl, or without an entry, it enlarges.
 */
final class NeedleTool implements SceneViewport.MouseTool {
    private final RehearsalController rehearsal;

    NeedleTool(RehearsalController rehearsal) {
        this.rehearsal = rehearsal;
    }

    @Override
    public boolean isPicking() {
        return rehearsal.pickMode().mode() != PickMode.Kind.NONE;
    }

    @Override
    public double pickOpacity(Surface surface) {
        StructureKind sought =
                rehearsal.pickMode().mode() == PickMode.Kind.TARGET ? StructureKind.LIVER : StructureKind.SKIN;
        return surface.kind() == sought ? 1 : 0;
    }

    @Override
    public void picked(Optional<PickResult> found) {
        if (isPicking()) {
            rehearsal.pickMode().picked(found);
        }
    }

    @Override
    public boolean wheelTurned(MouseWheelEvent e) {
        return !e.isControlDown() && rehearsal.needle().wheelTurned(e);
    }
}
