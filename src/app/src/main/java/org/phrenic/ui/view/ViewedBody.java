package org.phrenic.ui.view;

import org.phrenic.scene.camera.BoundingBox;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Surface;

/** What tells a body in the view from another one, which is looked at anew. */
public final class ViewedBody {
    private final String anatomy;
    private final double[] bounds;

    ViewedBody(String anatomy, double[] bounds) {
        this.anatomy = anatomy;
        this.bounds = bounds.clone();
    }

    public static ViewedBody of(LiveScene scene) {
        return new ViewedBody(scene.scenario().anatomy(), Surface.bounds(scene.surfaces()));
    }

    /** Whether another scene shows this body, if in another resolution. */
    public boolean isAlso(ViewedBody other) {
        return anatomy.equals(other.anatomy) && BoundingBox.areAlike(bounds, other.bounds);
    }

    public double[] bounds() {
        return bounds.clone();
    }
}
