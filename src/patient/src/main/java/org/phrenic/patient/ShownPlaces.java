package org.phrenic.patient;

import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Where a scan shows points of structures that have been moved since: a point goes back as the nearest point of their
 * surface does, whose displacement is linear in each triangle between those of its corners. Not thread-safe.
 */
public final class ShownPlaces {
    private final TriangleMesh moved;
    private final double[] shown;
    private final TriangleTree tree;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    /**
     * @param moved surface as it lies now
     * @param shown vertices of the surface where the scan shows them, x, y, z in turn, mm
     */
    public ShownPlaces(TriangleMesh moved, double[] shown) {
        this.moved = moved;
        this.shown = shown;
        tree = new TriangleTree(moved);
    }

    /**
     * Moves a point to where the scan shows it, unless the surface has no triangles.
     *
     * @param points x, y, z in turn, mm
     * @param at index of the x of the point
     * @return the nearest point of the surface as it lies now, valid until the next call
     */
    public TriangleTree.Hit apply(double[] points, int at) {
        if (tree.closest(points[at], points[at + 1], points[at + 2], hit)) {
            double[] now = moved.positions();
            double[] weights = {hit.weightA, hit.weightB, hit.weightC};
            for (int corner = 0; corner < 3; corner++) {
                int v = 3 * moved.triangles()[3 * hit.triangle + corner];
                for (int axis = 0; axis < 3; axis++) {
                    points[at + axis] += weights[corner] * (shown[v + axis] - now[v + axis]);
                }
            }
        }
        return hit;
    }
}
