package org.phrenic.mesh;

import java.util.Arrays;
import org.phrenic.engine.math.RadixSort;

/**
 * The unique edges of a {@link TriangleMesh} and the triangles at each: the part of a {@link MeshTopology} that does
 * without the neighbours of vertices, for half of its time. Built in O(n log n), as flat integer arrays, which are
 * shared and must not be written to.
 *
 * <p>Edges are numbered in lexicographic order of their vertex pair (a, b), a &lt; b, so the numbering depends on the
 * triangles alone, not on their order. A side of a triangle that joins a vertex to itself (a degenerate triangle) is no
 * edge.
 */
public final class EdgeTable {
    public static final int NONE = -1;

    /** Vertex pairs (a, b), a &lt; b, two numbers an edge. */
    public final int[] edges;
    /** Two triangles an edge, {@link #NONE} where there is only one; of a non-manifold edge the first two. */
    final int[] edgeTriangles;
    /** How many triangles each edge has. */
    public final int[] edgeTriangleCount;
    /** Three edges a triangle: the i-th joins corners i and i + 1; {@link #NONE} where these are the same vertex. */
    public final int[] triangleEdges;

    // Each loop stands in a method of its own: compilers work on whole methods, and these are run on many meshes at the
    // start of a program.
    public EdgeTable(TriangleMesh mesh) {
        int[] triangles = mesh.triangles();
        int[] row = rowStarts(triangles, mesh.vertexCount());
        long[] keys = keys(triangles, row);
        int count = 0;
        for (int v = 0; v + 1 < row.length; v++) {
            RadixSort.sort(keys, row[v], row[v + 1]);
            count += distinct(keys, row[v], row[v + 1]);
        }
        triangleEdges = new int[triangles.length];
        if (keys.length < triangles.length) {
            Arrays.fill(triangleEdges, NONE);
        }
        edges = new int[2 * count];
        edgeTriangles = new int[2 * count];
        edgeTriangleCount = new int[count];
        int next = 0;
        for (int v = 0; v + 1 < row.length; v++) {
            next = number(v, keys, row[v], row[v + 1], next);
        }
    }

    /** Where the row of each smaller vertex begins; one more at the end. */
    private static int[] rowStarts(int[] triangles, int vertexCount) {
        int[] row = new int[vertexCount + 1];
        for (int side = 0; side < triangles.length; side++) {
            int a = triangles[side];
            int b = triangles[next(side)];
            if (a != b) {
                row[Math.min(a, b) + 1]++;
            }
        }
        for (int v = 0; v < vertexCount; v++) {
            row[v + 1] += row[v];
        }
        return row;
    }

    /** The sides in rows by smaller vertex, each as larger vertex and side in one number. */
    private static long[] keys(int[] triangles, int[] row) {
        long[] keys = new long[row[row.length - 1]];
        int[] fill = row.clone();
        for (int side = 0; side < triangles.length; side++) {
            int a = triangles[side];
            int b = triangles[next(side)];
            if (a != b) {
                keys[fill[Math.min(a, b)]++] = ((long) Math.max(a, b) << 32) | side;
            }
        }
        return keys;
    }

    /** How many vertices the sides of one sorted row lead to. */
    private static int distinct(long[] keys, int from, int to) {
        int count = 0;
        for (int k = from; k < to; k++) {
            count += k == from || keys[k] >>> 32 != keys[k - 1] >>> 32 ? 1 : 0;
        }
        return count;
    }

    /** Numbers the edges of one sorted row from {@code first} on; returns the next number. */
    private int number(int v, long[] keys, int from, int to, int first) {
        int count = first;
        int previous = NONE;
        for (int k = from; k < to; k++) {
            int other = (int) (keys[k] >>> 32);
            int side = (int) keys[k];
            if (other != previous) {
                edges[2 * count] = v;
                edges[2 * count + 1] = other;
                edgeTriangles[2 * count + 1] = NONE;
                previous = other;
                count++;
            }
            int edge = count - 1;
            triangleEdges[side] = edge;
            if (edgeTriangleCount[edge] < 2) {
                edgeTriangles[2 * edge + edgeTriangleCount[edge]] = side / 3;
            }
            edgeTriangleCount[edge]++;
        }
        return count;
    }

    public int count() {
        return edgeTriangleCount.length;
    }

    /** The triangle on the other side of a manifold edge, {@link #NONE} on a boundary. */
    public int otherTriangle(int edge, int triangle) {
        return edgeTriangles[2 * edge] == triangle ? edgeTriangles[2 * edge + 1] : edgeTriangles[2 * edge];
    }

    /** Each edge of the triangle has exactly two triangles. */
    public boolean isInteriorTriangle(int triangle) {
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            int edge = triangleEdges[side];
            if (edge == NONE || edgeTriangleCount[edge] != 2) {
                return false;
            }
        }
        return true;
    }

    /** Every edge has exactly two triangles, and there is one. */
    public boolean isClosed() {
        for (int triangles : edgeTriangleCount) {
            if (triangles != 2) {
                return false;
            }
        }
        return edgeTriangleCount.length > 0;
    }

    /** No edge has more than two triangles. */
    boolean isEdgeManifold() {
        for (int triangles : edgeTriangleCount) {
            if (triangles > 2) {
                return false;
            }
        }
        return true;
    }

    /** The side after this one round its triangle. */
    public static int next(int side) {
        return side % 3 == 2 ? side - 2 : side + 1;
    }
}
