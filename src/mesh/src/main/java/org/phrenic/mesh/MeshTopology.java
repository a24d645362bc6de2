package org.phrenic.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What touches what in a {@link TriangleMesh}: unique edges, the edges and triangles at a vertex, the triangles at an
 * edge, boundary loops and connected components. The first four are built once, in O(n log n), as flat integer arrays.
 *
 * <p>Edges are numbered in lexicographic order of their vertex pair (a, b), a &lt; b, so the numbering depends on the
 * triangles alone, not on their order. A side of a triangle that joins a vertex to itself (a degenerate triangle) is no
 * edge. The neighbour lists are in compressed rows: those of vertex {@code v} stand at {@code start[v]} to
 * {@code start[v + 1] - 1}, ascending. All arrays are shared and must not be written to.
 */
public final class MeshTopology {
    private static final int NONE = EdgeTable.NONE;

    private final TriangleMesh mesh;
    private final EdgeTable table;
    private final int[] edges;
    private final int[] edgeTriangles;
    private final int[] edgeTriangleCount;
    private final int[] triangleEdges;
    private final int[] vertexEdgeStart;
    private final int[] vertexEdges;
    private final int[] vertexTriangleStart;
    private final int[] vertexTriangles;

    public MeshTopology(TriangleMesh mesh) {
        this.mesh = mesh;
        table = new EdgeTable(mesh);
        edges = table.edges;
        edgeTriangles = table.edgeTriangles;
        edgeTriangleCount = table.edgeTriangleCount;
        triangleEdges = table.triangleEdges;
        int vertexCount = mesh.vertexCount();
        int[] triangles = mesh.triangles();

        vertexEdgeStart = new int[vertexCount + 1];
        vertexEdges = rows(edges, 2, vertexEdgeStart);
        vertexTriangleStart = new int[vertexCount + 1];
        vertexTriangles = rows(triangles, 3, vertexTriangleStart);
    }

    /** Compressed rows vertex to item, from items that name {@code width} vertices each; fills {@code start}. */
    private static int[] rows(int[] items, int width, int[] start) {
        int vertexCount = start.length - 1;
        for (int k = 0; k < items.length; k++) {
            if (firstMention(items, width, k)) {
                start[items[k] + 1]++;
            }
        }
        for (int v = 0; v < vertexCount; v++) {
            start[v + 1] += start[v];
        }
        int[] fill = Arrays.copyOf(start, vertexCount);
        int[] row = new int[start[vertexCount]];
        for (int k = 0; k < items.length; k++) {
            if (firstMention(items, width, k)) {
                row[fill[items[k]]++] = k / width;
            }
        }
        return row;
    }

    /**
     * False for the second mention of a vertex within one item: a degenerate triangle stands once in a vertex's row.
     */
    private static boolean firstMention(int[] items, int width, int k) {
        for (int j = k - k % width; j < k; j++) {
            if (items[j] == items[k]) {
                return false;
            }
        }
        return true;
    }

    /** Whether the triangles at each vertex form a single fan, open or closed (edges are known to have at most two). */
    private boolean isVertexManifold() {
        for (int v = 0; v < mesh.vertexCount(); v++) {
            int from = vertexTriangleStart[v];
            int to = vertexTriangleStart[v + 1];
            if (from == to) {
                continue;
            }
            int edge = vertexEdges[vertexEdgeStart[v]];
            for (int k = vertexEdgeStart[v]; k < vertexEdgeStart[v + 1]; k++) {
                if (edgeTriangleCount[vertexEdges[k]] == 1) {
                    edge = vertexEdges[k];
                    break;
                }
            }
            int first = edge;
            int triangle = edgeTriangles[2 * edge];
            int seen = 0;
            while (triangle != NONE && seen <= to - from) {
                seen++;
                edge = otherEdgeAt(triangle, v, edge);
                if (edge == NONE || edge == first) {
                    break;
                }
                triangle = otherTriangle(edge, triangle);
            }
            if (seen != to - from) {
                return false;
            }
        }
        return true;
    }

    /** The edge of {@code triangle} at vertex {@code v} that is not {@code edge}; -1 in a degenerate triangle. */
    private int otherEdgeAt(int triangle, int v, int edge) {
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            int e = triangleEdges[side];
            if (e != NONE && e != edge && (edges[2 * e] == v || edges[2 * e + 1] == v)) {
                return e;
            }
        }
        return NONE;
    }

    public TriangleMesh mesh() {
        return mesh;
    }

    public int edgeCount() {
        return table.count();
    }

    /** Vertex pairs (a, b), a &lt; b, two numbers an edge, in lexicographic order. */
    public int[] edges() {
        return edges;
    }

    /** Two triangles an edge, -1 where there is only one; of a non-manifold edge the first two. */
    public int[] edgeTriangles() {
        return edgeTriangles;
    }

    /** Three edges a triangle: the i-th joins corners i and i + 1; -1 where these are the same vertex. */
    public int[] triangleEdges() {
        return triangleEdges;
    }

    public int[] vertexEdgeStart() {
        return vertexEdgeStart;
    }

    public int[] vertexEdges() {
        return vertexEdges;
    }

    public int[] vertexTriangleStart() {
        return vertexTriangleStart;
    }

    public int[] vertexTriangles() {
        return vertexTriangles;
    }

    /**
     * Component label of each vertex, numbered by the lowest vertex in it; a vertex without edges is one of its own.
     * Worked out anew at each call.
     */
    public int[] componentOfVertex() {
        int[] component = new int[mesh.vertexCount()];
        Arrays.fill(component, NONE);
        int[] queue = new int[component.length];
        int labels = 0;
        for (int seed = 0; seed < component.length; seed++) {
            if (component[seed] != NONE) {
                continue;
            }
            int head = 0;
            int tail = 0;
            queue[tail++] = seed;
            component[seed] = labels;
            while (head < tail) {
                int v = queue[head++];
                for (int k = vertexEdgeStart[v]; k < vertexEdgeStart[v + 1]; k++) {
                    int other = otherVertex(vertexEdges[k], v);
                    if (component[other] == NONE) {
                        component[other] = labels;
                        queue[tail++] = other;
                    }
                }
            }
            labels++;
        }
        return component;
    }

    /** How many labels {@link #componentOfVertex} has. Worked out anew at each call. */
    public int componentCount() {
        int highest = NONE;
        for (int label : componentOfVertex()) {
            highest = Math.max(highest, label);
        }
        return highest + 1;
    }

    public int otherVertex(int edge, int vertex) {
        return edges[2 * edge] == vertex ? edges[2 * edge + 1] : edges[2 * edge];
    }

    /** The triangle on the other side of a manifold edge, -1 on a boundary. */
    public int otherTriangle(int edge, int triangle) {
        return table.otherTriangle(edge, triangle);
    }

    public boolean isBoundaryEdge(int edge) {
        return edgeTriangleCount[edge] == 1;
    }

    /** True for an edge of three or more triangles. */
    public boolean isNonManifoldEdge(int edge) {
        return edgeTriangleCount[edge] > 2;
    }

    /** Whether every edge of a mesh has exactly two triangles; without working out the rest. */
    public static boolean isClosed(TriangleMesh mesh) {
        return new EdgeTable(mesh).isClosed();
    }

    /** Every edge has exactly two triangles. */
    public boolean isClosed() {
        return table.isClosed();
    }

    /**
     * No edge has more than two triangles, and the triangles at each vertex form one fan. Worked out anew at each call.
     */
    public boolean isManifold() {
        return table.isEdgeManifold() && isVertexManifold();
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
            int first = triangleEdges[side];
            if (first == NONE || edgeTriangleCount[first] != 1 || done[first]) {
                continue;
            }
            int length = 0;
            int edge = first;
            int vertex = triangles[side];
            boolean complete = true;
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

    /** Turns about {@code vertex} through the fan that {@code edge} bounds, to the fan's other boundary edge. */
    private int nextBoundaryEdge(int edge, int vertex) {
        int triangle = edgeTriangles[2 * edge];
        int current = edge;
        while (true) {
            current = otherEdgeAt(triangle, vertex, current);
            if (current == NONE || edgeTriangleCount[current] > 2) {
                return NONE;
            }
            if (edgeTriangleCount[current] == 1) {
                return current;
            }
            triangle = otherTriangle(current, triangle);
        }
    }
}
