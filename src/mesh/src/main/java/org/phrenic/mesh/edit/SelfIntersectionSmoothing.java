package org.phrenic.mesh.edit;

import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SelfIntersections;

/**
 * Smooths a surface where it passes through itself, as at a sharp edge whose two sides cross. Vertices of crossing
 * edges and triangles, and their neighbours, go half way to the mean of their neighbours (Laplacian smoothing), round
 * by round until nothing crosses. A surface that does not cross itself is returned as it is.
 */
public final class SelfIntersectionSmoothing {
    private static final int MAX_ROUNDS = 30;

    private SelfIntersectionSmoothing() {}

    /** The smoothed surface; after {@value #MAX_ROUNDS} rounds some self-intersections may be left. */
    public static TriangleMesh smooth(TriangleMesh mesh) {
        MeshTopology topology = new MeshTopology(mesh);
        TriangleMesh smoothed = mesh;
        for (int round = 0; round < MAX_ROUNDS; round++) {
            boolean[] crossing = SelfIntersections.vertices(smoothed, topology.edges());
            boolean[] moved = withNeighbours(crossing, topology.edges());
            if (moved == null) {
                return smoothed;
            }
            smoothed = smoothed.withPositions(relaxed(smoothed.positions(), moved, topology));
        }
        return smoothed;
    }

    /** Null if no vertex is marked. */
    private static boolean[] withNeighbours(boolean[] marked, int[] edges) {
        boolean[] grown = marked.clone();
        boolean any = false;
        for (int e = 0; e < edges.length; e += 2) {
            boolean either = marked[edges[e]] || marked[edges[e + 1]];
            any |= either;
            grown[edges[e]] |= either;
            grown[edges[e + 1]] |= either;
        }
        return any ? grown : null;
    }

    private static double[] relaxed(double[] p, boolean[] moved, MeshTopology topology) {
        double[] out = p.clone();
        int[] edges = topology.edges();
        int[] start = topology.vertexEdgeStart();
        int[] rows = topology.vertexEdges();
        for (int v = 0; v < moved.length; v++) {
            int count = start[v + 1] - start[v];
            for (int axis = 0; moved[v] && axis < 3; axis++) {
                double sum = 0;
                for (int k = start[v]; k < start[v + 1]; k++) {
                    int other = edges[2 * rows[k]] + edges[2 * rows[k] + 1] - v;
                    sum += p[3 * other + axis];
                }
                out[3 * v + axis] = 0.5 * p[3 * v + axis] + 0.5 * sum / count;
            }
        }
        return out;
    }
}
