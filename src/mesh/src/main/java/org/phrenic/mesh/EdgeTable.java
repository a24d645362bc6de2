package org.phrenic.mesh;

import java.util.Arrays;
import org.phrenic.engine.math.RadixSort;

/**
 * The unique edges of a polygon mesh whose faces all have n corners, and the faces at each edge. It is a
 * {@link MeshTopology} without vertex adjacency and takes half the time to build, O(m log m). The integer arrays are
 * shared and must not be modified.
 *
 * <p>Side {@code n f + i} runs from corner i of face f to its next corner. Edges are in lexicographic order of their
 * vertex pair (a, b), a &lt; b. A side that joins a vertex to itself (degenerate face) is not an edge.
 */
public class EdgeTable {
    /** Stands for an edge or a triangle that does not exist. */
    public static final int NONE = -1;

    private final int corners;
    private final int[] edges;
    private final int[] edgeStart;
    private final int[] sides;
    private final int[] edgeOfSide;

    /** Edges of a triangle mesh. */
    public EdgeTable(TriangleMesh mesh) {
        this(mesh.vertexCount(), mesh.triangles(), 3);
    }

    /**
     * Edges of a polygon mesh.
     *
     * @param vertexCount number of vertices of the mesh
     * @param faces vertex indices, {@code corners} for each face
     * @param corners number of corners of every face, at least 3
     */
    public EdgeTable(int vertexCount, int[] faces, int corners) {
        this.corners = corners;
        int[] row = rowStarts(faces, vertexCount);
        long[] keys = keys(faces, row);
        int count = 0;
        for (int v = 0; v < vertexCount; v++) {
            RadixSort.sort(keys, row[v], row[v + 1]);
            count += distinct(keys, row[v], row[v + 1]);
        }
        edgeOfSide = new int[faces.length];
        if (keys.length < faces.length) {
            Arrays.fill(edgeOfSide, NONE);
        }
        edges = new int[2 * count];
        edgeStart = new int[count + 1];
        sides = new int[keys.length];
        edgeStart[count] = keys.length;
        int next = 0;
        for (int v = 0; v < vertexCount; v++) {
            next = number(v, keys, row[v], row[v + 1], next);
        }
    }

    // Each loop has its own method. The just-in-time compiler compiles whole methods, and these run on many meshes at
    // start-up.
    /** First key of each vertex as the smaller end of an edge; the last entry is the total. */
    private int[] rowStarts(int[] faces, int vertexCount) {
        int[] row = new int[vertexCount + 1];
        for (int side = 0, first = 0; side < faces.length; side++) {
            first += side == first + corners ? corners : 0;
            int a = faces[side];
            int b = faces[side + 1 == first + corners ? first : side + 1];
            if (a != b) {
                row[Math.min(a, b) + 1]++;
            }
        }
        for (int v = 0; v < vertexCount; v++) {
            row[v + 1] += row[v];
        }
        return row;
    }

    /** The sides in rows by smaller vertex, each packed as (larger vertex, side). */
    private long[] keys(int[] faces, int[] row) {
        long[] keys = new long[row[row.length - 1]];
        int[] fill = row.clone();
        for (int side = 0, first = 0; side < faces.length; side++) {
            first += side == first + corners ? corners : 0;
            int a = faces[side];
            int b = faces[side + 1 == first + corners ? first : side + 1];
            if (a != b) {
                keys[fill[Math.min(a, b)]++] = ((long) Math.max(a, b) << 32) | side;
            }
        }
        return keys;
    }

    /** Number of distinct larger vertices in one sorted row. */
    private static int distinct(long[] keys, int from, int to) {
        int count = 0;
        for (int k = from; k < to; k++) {
            count += k == from || keys[k] >>> 32 != keys[k - 1] >>> 32 ? 1 : 0;
        }
        return count;
    }

    /** Numbers the edges of one sorted row, starting at {@code first}; returns the next free number. */
    private int number(int v, long[] keys, int from, int to, int first) {
        int count = first;
        int previous = NONE;
        for (int k = from; k < to; k++) {
            int other = (int) (keys[k] >>> 32);
            if (other != previous) {
                edges[2 * count] = v;
                edges[2 * count + 1] = other;
                edgeStart[count++] = k;
                previous = other;
            }
            sides[k] = (int) keys[k];
            edgeOfSide[sides[k]] = count - 1;
        }
        return count;
    }

    public final int edgeCount() {
        return edges.length / 2;
    }

    /** Vertex pairs (a, b), a &lt; b, two numbers per edge, in lexicographic order. */
    public int[] edges() {
        return edges;
    }

    /** The sides of edge e are {@code sides()[start(e)]} to {@code sides()[start(e + 1) - 1]}, ascending. */
    public int[] sides() {
        return sides;
    }

    /** Index of the first side of an edge in {@link #sides}; the edge may also be {@link #edgeCount}. */
    public int start(int edge) {
        return edgeStart[edge];
    }

    /** Number of faces at an edge. */
    public int faceCount(int edge) {
        return edgeStart[edge + 1] - edgeStart[edge];
    }

    /** The i-th face of an edge; {@link #NONE} if the edge has at most i faces. */
    public int face(int edge, int i) {
        int place = edgeStart[edge] + i;
        return place < edgeStart[edge + 1] ? sides[place] / corners : NONE;
    }

    /** The edge of each side; {@link #NONE} for a side that joins a vertex to itself. */
    public int[] edgeOfSide() {
        return edgeOfSide;
    }

    /** The other face of an edge with two faces; {@link #NONE} on a boundary. */
    public int otherFace(int edge, int face) {
        return face(edge, 0) == face ? face(edge, 1) : face(edge, 0);
    }

    /** Whether each edge of the face has exactly two faces. */
    public boolean isInteriorFace(int face) {
        for (int side = corners * face; side < corners * (face + 1); side++) {
            int edge = edgeOfSide[side];
            if (edge == NONE || faceCount(edge) != 2) {
                return false;
            }
        }
        return true;
    }

    /** Whether every edge has exactly two faces; false for a mesh without edges. */
    public boolean isClosed() {
        for (int e = 0; e < edgeCount(); e++) {
            if (faceCount(e) != 2) {
                return false;
            }
        }
        return edgeCount() > 0;
    }

    /** Whether no edge has more than two faces. */
    public boolean isEdgeManifold() {
        for (int e = 0; e < edgeCount(); e++) {
            if (faceCount(e) > 2) {
                return false;
            }
        }
        return true;
    }

    /** The next side of the same face, which has the given number of corners. */
    public static int next(int side, int corners) {
        return (side + 1) % corners == 0 ? side + 1 - corners : side + 1;
    }

    /** The other end of an edge. */
    public int otherVertex(int edge, int vertex) {
        return edges[2 * edge] == vertex ? edges[2 * edge + 1] : edges[2 * edge];
    }
}
