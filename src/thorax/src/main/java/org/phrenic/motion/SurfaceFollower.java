package org.phrenic.motion;

import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * A displacement field made exact on a surface. To the field at X is added what it misses at the nearest point of the
 * surface, less with distance d:
 *
 * <pre>  u(X) = f(X) + g(d) (v(P) - f(P))</pre>
 *
 * v is linear in each triangle between the displacements of its corners, g falls from 1 to 0 over a stated reach.
 */
final class SurfaceFollower {
    private final TriangleMesh rest;
    private final TriangleTree tree;
    private final double reachMm;

    SurfaceFollower(TriangleMesh rest, double reachMm) {
        this.rest = rest;
        this.reachMm = reachMm;
        tree = new TriangleTree(rest);
    }

    /** The field with the correction, for the surface's vertices at {@code now}. */
    RegionField exact(RegionField field, double[] now) {
        return (x, y, z, out) -> {
            field.at(x, y, z, out);
            TriangleTree.Hit hit = new TriangleTree.Hit();
            if (!tree.closest(x, y, z, reachMm, hit)) {
                return;
            }
            double share = FallOff.at(Math.sqrt(hit.distanceSquared), reachMm);
            double[] own = new double[3];
            field.at(hit.x, hit.y, hit.z, own);
            for (int axis = 0; axis < 3; axis++) {
                out[axis] += share * (moved(hit, axis, now) - own[axis]);
            }
        };
    }

    private double moved(TriangleTree.Hit hit, int axis, double[] now) {
        int t = 3 * hit.triangle;
        double[] p = rest.positions();
        int a = 3 * rest.triangles()[t] + axis;
        int b = 3 * rest.triangles()[t + 1] + axis;
        int c = 3 * rest.triangles()[t + 2] + axis;
        return hit.weightA * (now[a] - p[a]) + hit.weightB * (now[b] - p[b]) + hit.weightC * (now[c] - p[c]);
    }
}
