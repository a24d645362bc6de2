package org.phrenic.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.engine.math.DisjointSets;

/**
 * Adjacency of a {@link TriangleMesh}: its {@link EdgeTable} and the edges and triangles at each vertex. It gives
 * boundary loops, connected components and manifold tests.
 *
 * <p>Vertex adjacency is in compressed rows: the row of vertex {@code v} is at {@code start[v]} to {@code start[v + 1]
 * - 1}, ascending. All arrays are shared and must not be modified.
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

    /** Builds compressed rows from vertices to items with {@code width} vertices each; fills {@code start}. */
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

    /** False if the item contains the same vertex earlier, so a degenerate triangle occurs once in a vertex's row. */
    private static boolean isFirstMention(int[] items, int width, int k) {
        for (int j = k - k % width; j < k; j++) {
            if (items[j] == items[k]) {
                return false;
            }
        }
        return true;
    }

    /**
     * Whether the triangles at each vertex form a single open or closed fan; a triangle with one vertex alone has no
     * edge and forms none. Requires at most two triangles per edge.
     */
    private boolean isVertexManifold() {
        for (int v = 0; v < mesh.vertexCount(); v++) {
            int count = vertexTriangleStart[v + 1] - vertexTriangleStart[v];
            boolean hasEdge = vertexEdgeStart[v] < vertexEdgeStart[v + 1];
            if (count > 0 && !(hasEdge && fanSize(v, count) == count)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Number of triangles reached by walking around {@code v} across edges, from a boundary edge if there is one. Stops
     * at {@code most} + 1.
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
     * The other edge of {@code triangle} at vertex {@code v} besides {@code edge}; {@link #NONE} in a degenerate
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

    /** Number of connected components; an isolated vertex is one. Computed at each call. */
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

    /**
     * Whether every edge has at most two triangles and the triangles at each vertex form one fan. Computed at each
     * call.
     */
    public boolean isManifold() {
        return isEdgeManifold() && isVertexManifold();
    }

    /** Euler characteristic: used vertices - edges + triangles; 2 for a sphere, 0 for a torus. */
    public int eulerCharacteristic() {
        int used = 0;
        for (int v = 0; v < mesh.vertexCount(); v++) {
            used += vertexTriangleStart[v + 1] > vertexTriangleStart[v] ? 1 : 0;
        }
        return used - edgeCount() + mesh.triangleCount();
    }

    /**
     * Boundary loops: closed chains of edges with one triangle, as vertices in the direction of the triangle sides. Two
     * loops that touch at a vertex remain separate. A chain that ends at a non-manifold edge is omitted.
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
     * The next boundary edge at {@code vertex}, at the other end of the fan that {@code edge} bounds; {@link #NONE} if
     * a non-manifold edge is in between.
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
