package org.phrenic.mesh.edit;

import java.util.Arrays;
import org.phrenic.mesh.BoundingBoxes;
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
        SelfIntersections intersections = new SelfIntersections(mesh);
        double[] positions = mesh.positions();
        int[] tried = topology.edges();
        for (int round = 0; round < MAX_ROUNDS; round++) {
            boolean[] moved = withNeighbours(intersections.vertices(tried), topology.edges());
            if (moved == null) {
                break;
            }
            positions = relaxed(positions, moved, topology);
            intersections.moveTo(positions);
            tried = edgesNear(moved, positions, topology.edges());
        }
        return positions == mesh.positions() ? mesh : mesh.withPositions(positions);
    }

    /**
     * The edges that touch the box of all triangles with a vertex that has moved: what does not touch it crosses
     * nothing that it did not cross before.
     */
    private static int[] edgesNear(boolean[] moved, double[] p, int[] edges) {
        double[] box = new double[6];
        BoundingBoxes.setEmpty(box, 0);
        for (int e = 0; e < edges.length; e += 2) {
            if (moved[edges[e]] || moved[edges[e + 1]]) {
                BoundingBoxes.include(box, 0, p, 3 * edges[e]);
                BoundingBoxes.include(box, 0, p, 3 * edges[e + 1]);
            }
        }
        int[] near = new int[edges.length];
        int count = 0;
        for (int e = 0; e < edges.length; e += 2) {
            if (touches(box, p, 3 * edges[e], 3 * edges[e + 1])) {
                near[count++] = edges[e];
                near[count++] = edges[e + 1];
            }
        }
        return Arrays.copyOf(near, count);
    }

    private static boolean touches(double[] box, double[] p, int a, int b) {
        boolean touches = true;
        for (int axis = 0; axis < 3; axis++) {
            touches &= Math.max(p[a + axis], p[b + axis]) >= box[axis]
                    && Math.min(p[a + axis], p[b + axis]) <= box[3 + axis];
        }
        return touches;
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
