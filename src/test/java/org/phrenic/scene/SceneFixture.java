package org.phrenic.scene;

import java.util.List;
import org.phrenic.simulation.Surface;

/** What tests of this package share. */
final class SceneFixture {
    private SceneFixture() {}

    /** The box that holds all surfaces at rest. */
    static double[] bounds(List<Surface> surfaces) {
        double[] box = surfaces.get(0).rest().bounds();
        for (Surface s : surfaces) {
            double[] other = s.rest().bounds();
            for (int i = 0; i < 3; i++) {
                box[i] = Math.min(box[i], other[i]);
                box[3 + i] = Math.max(box[3 + i], other[3 + i]);
            }
        }
        return box;
    }
}
