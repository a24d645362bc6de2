package org.phrenic.scene.surface;

import java.util.List;
import org.phrenic.simulation.observe.Surface;

/** The bounding box of surfaces at rest. */
public final class SceneBounds {
    private SceneBounds() {}

    /** {@code {minX, minY, minZ, maxX, maxY, maxZ}} in mm; without surfaces, infinite with min greater than max. */
    public static double[] of(List<Surface> surfaces) {
        double[] box = {
            Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY
        };
        for (Surface surface : surfaces) {
            double[] one = surface.rest().bounds();
            for (int i = 0; i < 3; i++) {
                box[i] = Math.min(box[i], one[i]);
                box[3 + i] = Math.max(box[3 + i], one[3 + i]);
            }
        }
        return box;
    }
}
