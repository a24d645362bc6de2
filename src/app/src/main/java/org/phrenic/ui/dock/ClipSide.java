package org.phrenic.ui.dock;

import java.util.function.DoubleFunction;
import org.phrenic.scene.style.ClipPlane;

/** Side from which a clip plane cuts, along axis 0, 1 or 2; the plane moves with the axis if it goes forwards. */
enum ClipSide {
    NONE("No clip plane", 0, false, null),
    LEFT("From the left", 0, false, ClipPlane::sagittal),
    FRONT("From the front", 1, true, ClipPlane::coronal),
    ABOVE("From above", 2, false, ClipPlane::axial);

    private final String label;
    private final int axis;
    private final boolean forwards;
    private final DoubleFunction<ClipPlane> plane;

    ClipSide(String label, int axis, boolean forwards, DoubleFunction<ClipPlane> plane) {
        this.label = label;
        this.axis = axis;
        this.forwards = forwards;
        this.plane = plane;
    }

    int axis() {
        return axis;
    }

    boolean forwards() {
        return forwards;
    }

    /** The plane at a place along the axis, mm; none for {@link #NONE}. */
    ClipPlane plane(double mm) {
        return plane.apply(mm);
    }

    @Override
    public String toString() {
        return label;
    }
}
