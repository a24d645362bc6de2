package org.phrenic.ui;

import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.Pick;
import org.phrenic.simulation.Surface;

/** The mouse in the view while liver access is rehearsed: a click chooses entry or target when that is asked for, and the wheel moves the needle once an entry is chosen; with Ctrl, or without an entry, it enlarges. */
final class NeedleTool implements SceneView.Tool {
    private final RehearsalDoor door;

    NeedleTool(RehearsalDoor door) {
        this.door = door;
    }

    @Override
    public boolean isAwaiting() {
        return door.clicks().choosing() != ClickChoice.Of.NOTHING;
    }

    @Override
    public double catches(Surface surface) {
        StructureKind sought =
                door.clicks().choosing() == ClickChoice.Of.TARGET ? StructureKind.LIVER : StructureKind.SKIN;
        return surface.kind() == sought ? 1 : 0;
    }

    @Override
    public void clicked(Optional<Pick> found) {
        if (isAwaiting()) {
            door.clicks().chosen(found);
        }
    }

    @Override
    public boolean turned(MouseWheelEvent e) {
        return !e.isControlDown() && door.hand().turned(e);
    }
}
