package org.phrenic.geometry;

import java.util.Arrays;

/**
 * The unique edges of a {@link TriangleMesh} and the triangles at each: the part of a {@link MeshTopology} that does without the neighbours of
 * vertices, for half of its time. Built in O(n log n), as flat integer arrays, which are shared and must not be written to.
 *
 * <p>Edges are numbered in lexicographic order of their vertex pair (a, b), a &lt; b, so the numbering depends on the triangles
 * alone, not on their order. A side of a triangle that joins a vertex to itself (a degenerate triangle) is no edge.
 */
final class EdgeTable {
    static final int NONE = -1;

    /** Vertex pairs (a, b), a &lt; b, two numbers an edge. */
    final int[] edges;
    /** Two triangles an edge, {@link #NONE} where there is only one; of a non-manifold edge the first two. */
    final int[] edgeTriangles;
    /** How many triangles each edge has. */
    final int[] edgeTriangleCount;
    /** Three edges a triangle: the i-th joins corners i and i + 1; {@link #NONE} where these are the same vertex. */
    final int[] triangleEdges;

    EdgeTable(TriangleMesh mesh) {
        int vertexCount = mesh.vertexCount();
        int[] triangles = mesh.triangles();
        int sides = triangles.length;

        // Sides go into one bucket per smaller vertex; within a bucket they are sorted by the larger vertex, then by
        // side.
        int[] bucket = new int[vertexCount + 1];
        for (int side = 0; side < sides; side++) {
            int a = triangles[side];
            int b = triangles[next(side)];
            if (a != b) {
                bucket[Math.min(a, b) + 1]++;
            }
        }
        for (int v = 0; v < vertexCount; v++) {
            bucket[v + 1] += bucket[v];
        }
        long[] keys = new long[bucket[vertexCount]];
        int[] fill = Arrays.copyOf(bucket, vertexCount);
        for (int side = 0; side < sides; side++) {
            int a = triangles[side];
            int b = triangles[next(side)];
            if (a != b) {
                keys[fill[Math.min(a, b)]++] = ((long) Math.max(a, b) << 32) | side;
            }
        }
        triangleEdges = new int[sides];
        Arrays.fill(triangleEdges, NONE);
        int[] pairs = new int[2 * keys.length];
        int[] pairTriangles = new int[2 * keys.length];
        int[] pairCount = new int[keys.length];
        int count = 0;
        for (int v = 0; v < vertexCount; v++) {
            Arrays.sort(keys, bucket[v], bucket[v + 1]);
            int previous = NONE;
            for (int k = bucket[v]; k < bucket[v + 1]; k++) {
                int other = (int) (keys[k] >>> 32);
                int side = (int) keys[k];
                if (other != previous) {
                    pairs[2 * count] = v;
                    pairs[2 * count + 1] = other;
                    pairTriangles[2 * count + 1] = NONE;
                    previous = other;
                    count++;
                }
                int edge = count - 1;
                triangleEdges[side] = edge;
                if (pairCount[edge] < 2) {
                    pairTriangles[2 * edge + pairCount[edge]] = side / 3;
                }
                pairCount[edge]++;
            }
        }
        edges = Arrays.copyOf(pairs, 2 * count);
        edgeTriangles = Arrays.copyOf(pairTriangles, 2 * count);
        edgeTriangleCount = Arrays.copyOf(pairCount, count);
    }

    int count() {
        return edgeTriangleCount.length;
    }

    /** The triangle on the other side of a manifold edge, {@link #NONE} on a boundary. */
    int otherTriangle(int edge, int triangle) {
        return edgeTriangles[2 * edge] == triangle ? edgeTriangles[2 * edge + 1] : edgeTriangles[2 * edge];
    }

    /** Every edge has exactly two triangles, and there is one. */
    boolean isClosed() {
        for (int triangles : edgeTriangleCount) {
            if (triangles != 2) {
                return false;
            }
        }
        return edgeTriangleCount.length > 0;
    }

    /** No edge has more than two triangles. */
    boolean hasPairsAtMost() {
        for (int triangles : edgeTriangleCount) {
            if (triangles > 2) {
                return false;
            }
        }
        return true;
    }

    /** The side after this one round its triangle. */
    static int next(int side) {
        return side % 3 == 2 ? side - 2 : side + 1;
    }
}
