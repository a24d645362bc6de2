package org.phrenic.model.organ;

import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.TriangleMesh;

/**
 * Springs that connect adjacent surfaces: cartilage to sternum and to the cartilage above, and lobe to lobe across a
 * fissure.
 */
public final class TieSprings {
    private static final double REACH_MM = 6;
    /** Shortest tie. A spring needs a length above 0; where surfaces touch, the neighbouring vertices connect them. */
    private static final double MIN_LENGTH_MM = 0.5;

    private TieSprings() {}

    /**
     * Connects each vertex of a structure to the nearest vertex of every other structure within reach.
     *
     * @param firsts first node of each structure
     * @param stiffness of a tie, N/m
     */
    public static void connect(
            MassSpringBuilder parts, List<Structure> structures, List<Integer> firsts, double stiffness) {
        for (int i = 0; i < structures.size(); i++) {
            for (int j = 0; j < i; j++) {
                TriangleMesh a = structures.get(i).mesh();
                TriangleMesh b = structures.get(j).mesh();
                if (!boundsOverlap(a.bounds(), b.bounds())) {
                    continue;
                }
                NearestVertex nearest = new NearestVertex(b, v -> true);
                for (int v = 0; v < a.vertexCount(); v++) {
                    int other = nearest.find(a.x(v), a.y(v), a.z(v), REACH_MM);
                    double d = nearest.distance();
                    if (d < REACH_MM && d > MIN_LENGTH_MM) {
                        parts.passiveSprings.add(firsts.get(i) + v, firsts.get(j) + other, stiffness, d, 0);
                    }
                }
            }
        }
    }

    private static boolean boundsOverlap(double[] p, double[] q) {
        for (int axis = 0; axis < 3; axis++) {
            if (p[axis] > q[3 + axis] + REACH_MM || q[axis] > p[3 + axis] + REACH_MM) {
                return false;
            }
        }
        return true;
    }
}
