package org.phrenic.anatomy.virtual.shape;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/** Enforces a minimum distance between a mesh and a region; a blend of implicit surfaces is not an exact distance. */
public final class Clearance {
    private static final int STEPS = 10;

    private Clearance() {}

    /**
     * Pushes every vertex closer to the region than {@code least} mm away from it along the normal.
     *
     * @param away 1 to stay outside the region, -1 to stay inside
     */
    public static TriangleMesh enforce(TriangleMesh mesh, ImplicitSurface region, int away, double least) {
        double[] positions = mesh.positions().clone();
        for (int v = 0; v < positions.length; v += 3) {
            double[] p = Vectors.of(positions[v], positions[v + 1], positions[v + 2]);
            for (int i = 0; i < STEPS; i++) {
                double value = away * region.at(p);
                if (value > 3 * least) {
                    break;
                }
                double[] gradient = region.gradient(p);
                double steepness = Vectors.length(gradient);
                double missing = least - value / steepness;
                if (missing < 1e-3) {
                    break;
                }
                p = Vectors.addScaled(p, gradient, away * missing / steepness);
            }
            System.arraycopy(p, 0, positions, v, 3);
        }
        return mesh.withPositions(positions);
    }
}
