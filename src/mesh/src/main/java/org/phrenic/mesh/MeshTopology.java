package org.phrenic.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.engine.math.DisjointSets;

/**
 * Adjacency of a {@link TriangleMesh}: its {@link EdgeTable} (face = triangle) and the edges and triangles at each
 * vertex; from these boundary loops, connected components and tests for manifolds.
 *
 * <p>The lists of a vertex are in compressed rows: those of vertex {@code v} are at {@code start[v]} to {@code start[v
 * + 1] - 1}, ascending. All arrays are shared and must not be written to.
 */
public final class MeshTopology extends EdgeTable {
    private final TriangleMesh mesh;
    private final int[] vertexEdgeStart;
    private final int[] vertexEdges;
    private final int[] vertexTriangleStart;
    private final int[] vertexTriangles;

    public MeshTopology(TriangleMesh mesh) {
        super(mesh);
        this.mesh = mesh;
        vertexEdgeStart = new int[mesh.vertexCount() + 1];
        vertexEdges = rows(edges(), 2, vertexEdgeStart);
        vertexTriangleStart = new int[mesh.vertexCount() + 1];
        vertexTriangles = rows(mesh.triangles(), 3, vertexTriangleStart);
    }

    /** Compressed rows vertex to item, from items that name {@code width} vertices each; fills {@code start}. */
    private static int[] rows(int[] items, int width, int[] start) {
        int vertexCount = start.length - 1;
        for (int k = 0; k < items.length; k++) {
            if (isFirstMention(items, width, k)) {
                start[items[k] + 1]++;
            }
        }
        for (int v = 0; v < vertexCount; v++) {
            start[v + 1] += start[v];
        }
        int[] fill = Arrays.copyOf(start, vertexCount);
        int[] row = new int[start[vertexCount]];
        for (int k = 0; k < items.length; k++) {
            if (isFirstMention(items, width, k)) {
                row[fill[items[k]]++] = k / width;
            }
        }
        return row;
    }

    /** False where an item names a vertex again: a degenerate triangle is once in a vertex's row. */
    private static boolean isFirstMention(int[] items, int width, int k) {
        for (int j = k - k % width; j < k; j++) {
            if (items[j] == items[k]) {
                return false;
            }
        }
        return true;
    }

    /** Whether the triangles at each vertex form a single fan, open or closed, given that edges have at most two. */
    private boolean isVertexManifold() {
        for (int v = 0; v < mesh.vertexCount(); v++) {
            int count = vertexTriangleStart[v + 1] - vertexTriangleStart[v];
            if (count > 0 && fanSize(v, count) != count) {
                return false;
            }
        }
        return true;
    }

    /**
     * Number of triangles met going round {@code v} across edges, from a boundary edge if there is one; at most one
     * above {@code most}.
     */
    private int fanSize(int v, int most) {
        int edge = vertexEdges[vertexEdgeStart[v]];
        for (int k = vertexEdgeStart[v]; k < vertexEdgeStart[v + 1]; k++) {
            if (faceCount(vertexEdges[k]) == 1) {
                edge = vertexEdges[k];
                break;
            }
        }
        int first = edge;
        int triangle = face(edge, 0);
        int seen = 0;
        while (triangle != NONE && seen <= most) {
            seen++;
            edge = otherEdgeAt(triangle, v, edge);
            if (edge == NONE || edge == first) {
                break;
            }
            triangle = otherFace(edge, triangle);
        }
        return seen;
    }

    /**
     * The edge of {@code triangle} at vertex {@code v} that is not {@code edge}; {@link #NONE} in a degenerate
     * triangle.
     */
    private int otherEdgeAt(int triangle, int v, int edge) {
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            int e = edgeOfSide()[side];
            if (e != NONE && e != edge && (edges()[2 * e] == v || edges()[2 * e + 1] == v)) {
                return e;
            }
        }
        return NONE;
    }

    /** Row starts of {@link #vertexEdges}. */
    public int[] vertexEdgeStart() {
        return vertexEdgeStart;
    }

    /** The edges at each vertex. */
    public int[] vertexEdges() {
        return vertexEdges;
    }

    /** Row starts of {@link #vertexTriangles}. */
    public int[] vertexTriangleStart() {
        return vertexTriangleStart;
    }

    /** The triangles at each vertex. */
    public int[] vertexTriangles() {
        return vertexTriangles;
    }

    /** Number of connected components; a vertex without edges is one. Computed at each call. */
    public int componentCount() {
        int[] parent = DisjointSets.singletons(mesh.vertexCount());
        for (int k = 0; k < edges().length; k += 2) {
            DisjointSets.unionToLower(parent, edges()[k], edges()[k + 1]);
        }
        int count = 0;
        for (int v = 0; v < parent.length; v++) {
            count += parent[v] == v ? 1 : 0;
        }
        return count;
    }

    /** No edge has more than two triangles, and the triangles at each vertex form one fan. Computed at each call. */
    public boolean isManifold() {
        return isEdgeManifold() && isVertexManifold();
    }

    /** Vertices - edges + triangles, counting only vertices that a triangle uses: 2 for a sphere, 0 for a torus. */
    public int eulerCharacteristic() {
        int used = 0;
        for (int v = 0; v < mesh.vertexCount(); v++) {
            used += vertexTriangleStart[v + 1] > vertexTriangleStart[v] ? 1 : 0;
        }
        return used - edgeCount() + mesh.triangleCount();
    }

    /**
     * The closed loops of edges that have one triangle, each as its vertices in the direction of the triangles' sides.
     * Where two loops touch in a vertex they stay apart; a chain that runs into a non-manifold edge is left out.
     */
    public List<int[]> boundaryLoops() {
        int[] triangles = mesh.triangles();
        boolean[] done = new boolean[edgeCount()];
        int[] chain = new int[edgeCount()];
        List<int[]> loops = new ArrayList<>();
        for (int side = 0; side < triangles.length; side++) {
            int first = edgeOfSide()[side];
            if (first == NONE || faceCount(first) != 1 || done[first]) {
                continue;
            }
            int length = 0;
            int edge = first;
            int vertex = triangles[side];
            boolean complete;
            do {
                done[edge] = true;
                chain[length++] = vertex;
                vertex = otherVertex(edge, vertex);
                edge = nextBoundaryEdge(edge, vertex);
                complete = edge != NONE && (edge == first || !done[edge]);
            } while (complete && edge != first);
            if (complete) {
                loops.add(Arrays.copyOf(chain, length));
            }
        }
        return loops;
    }

    /**
     * The other boundary edge of the fan at {@code vertex} that {@code edge} bounds; {@link #NONE} behind a
     * non-manifold edge.
     */
    private int nextBoundaryEdge(int edge, int vertex) {
        int triangle = face(edge, 0);
        int current = edge;
        while (true) {
            current = otherEdgeAt(triangle, vertex, current);
            if (current == NONE || faceCount(current) > 2) {
                return NONE;
            }
            if (faceCount(current) == 1) {
                return current;
            }
            triangle = otherFace(current, triangle);
        }
    }
}
