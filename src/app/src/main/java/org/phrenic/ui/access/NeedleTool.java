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
    private final RehearsalController door;

    NeedleTool(RehearsalController door) {
        this.door = door;
    }

    @Override
    public boolean isPicking() {
        return door.pickMode().mode() != PickMode.Kind.NONE;
    }

    @Override
    public double pickOpacity(Surface surface) {
        StructureKind sought =
                door.pickMode().mode() == PickMode.Kind.TARGET ? StructureKind.LIVER : StructureKind.SKIN;
        return surface.kind() == sought ? 1 : 0;
    }

    @Override
    public void picked(Optional<PickResult> found) {
        if (isPicking()) {
            door.pickMode().picked(found);
        }
    }

    @Override
    public boolean wheelTurned(MouseWheelEvent e) {
        return !e.isControlDown() && door.needle().wheelTurned(e);
    }
}
