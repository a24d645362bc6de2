package org.phrenic.model.organ;

import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/** Nearest-neighbour search among chosen vertices of a mesh, as triangles without area in a tree. Not thread-safe. */
public final class NearestVertex {
    private final int[] vertex;
    private final TriangleTree tree;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    public NearestVertex(TriangleMesh mesh, IntPredicate chosen) {
        vertex = IntStream.range(0, mesh.vertexCount()).filter(chosen).toArray();
        int[] corners = IntStream.of(vertex).flatMap(v -> IntStream.of(v, v, v)).toArray();
        tree = new TriangleTree(new TriangleMesh(mesh.positions(), corners));
    }

    /** Number of the nearest chosen vertex at any distance; -1 if no vertex is chosen. */
    public int find(double x, double y, double z) {
        return find(x, y, z, Double.POSITIVE_INFINITY);
    }

    /** Number of the nearest chosen vertex within {@code reach} mm; -1 if there is none. */
    int find(double x, double y, double z, double reach) {
        return tree.closest(x, y, z, reach, hit) ? vertex[hit.triangle] : -1;
    }

    /** Distance of the last vertex found, mm; infinite if none was found. */
    public double distance() {
        return Math.sqrt(hit.distanceSquared);
    }
}
