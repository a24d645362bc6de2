package org.phrenic.ui;

import java.util.Arrays;
import java.util.List;
import org.phrenic.simulation.Surface;

/** The box about a scene at rest. */
final class Bounds {
    private Bounds() {}

    /** {@code {minX, minY, minZ, maxX, maxY, maxZ}} in mm. */
    static double[] of(List<Surface> surfaces) {
        double[] box = new double[6];
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        for (Surface surface : surfaces) {
            double[] p = surface.rest().positions();
            for (int i = 0; i < p.length; i++) {
                box[i % 3] = Math.min(box[i % 3], p[i]);
                box[3 + i % 3] = Math.max(box[3 + i % 3], p[i]);
            }
        }
        return box;
    }
}
