package org.phrenic.mesh.voxel;

import java.util.Arrays;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;

/**
 * Triangulates the voxel faces of one part to a closed manifold. At an edge with four faces, the faces of the same
 * voxel are joined. Each fan of joined faces at a vertex gets its own vertex. If two pairs of faces at an edge still
 * share both ends, one pair gets an additional vertex at the edge midpoint.
 */
final class QuadStitcher {
    private static final int NONE = -1;

    private final double[] given;
    private final int[] quads;
    private final long[] voxels;
    private final EdgeTable edges;
    /** The joined side of each side. */
    private final int[] mate;
    /** Union-find parents of corners; the corners of one fan are one set. */
    private final int[] fan;

    private final int[] vertexOfFan;
    private final DoubleList positions = new DoubleList();
    /** Midpoint vertex of a side, if it has one. */
    private final int[] middle;

    private final IntList triangles = new IntList();

    /**
     * @param given positions of the quadrilaterals' vertices
     * @param quads four corners per face
     * @param voxels the voxel of each face
     */
    QuadStitcher(double[] given, int[] quads, long[] voxels) {
        this.given = given;
        this.quads = quads;
        this.voxels = voxels;
        edges = new EdgeTable(given.length / 3, quads, 4);
        mate = new int[quads.length];
        fan = DisjointSets.singletons(quads.length);
        vertexOfFan = new int[quads.length];
        middle = new int[quads.length];
        Arrays.fill(vertexOfFan, NONE);
        Arrays.fill(middle, NONE);
    }

    TriangleMesh mesh() {
        for (int e = 0; e < edges.edgeCount(); e++) {
            join(edges.start(e), edges.start(e + 1));
        }
        for (int corner = 0; corner < quads.length; corner++) {
            int root = DisjointSets.find(fan, corner);
            if (vertexOfFan[root] == NONE) {
                int v = 3 * quads[corner];
                vertexOfFan[root] = positions.add(given[v], given[v + 1], given[v + 2]);
            }
        }
        for (int e = 0; e < edges.edgeCount(); e++) {
            if (edges.faceCount(e) > 2) {
                separate(edges.start(e), edges.start(e + 1));
            }
        }
        for (int q = 0; q < quads.length / 4; q++) {
            cut(q);
        }
        return new TriangleMesh(positions.toArray(), triangles.toArray());
    }

    private void join(int from, int to) {
        for (int i = from; i < to; i++) {
            int side = edges.sides()[i];
            for (int j = i + 1; j < to; j++) {
                int other = edges.sides()[j];
                if (to - from == 2 || voxels[side >> 2] == voxels[other >> 2]) {
                    mate[side] = other;
                    mate[other] = side;
                    unite(side, other);
                    unite(next(side), other);
                }
            }
        }
    }

    private static int next(int side) {
        return EdgeTable.next(side, 4);
    }

    /** Merges the corners of two joined sides that have the same vertex. */
    private void unite(int corner, int side) {
        DisjointSets.unionToLower(fan, corner, quads[corner] == quads[side] ? side : next(side));
    }

    private int vertex(int corner) {
        return vertexOfFan[DisjointSets.find(fan, corner)];
    }

    /** Adds a midpoint vertex to the later of two pairs of faces at an edge that share both ends. */
    private void separate(int from, int to) {
        int first = edges.sides()[from];
        for (int i = from + 1; i < to; i++) {
            int side = edges.sides()[i];
            boolean sameEnds = Math.min(vertex(first), vertex(next(first)))
                            == Math.min(vertex(side), vertex(next(side)))
                    && Math.max(vertex(first), vertex(next(first))) == Math.max(vertex(side), vertex(next(side)));
            if (side != mate[first] && sameEnds && middle[side] == NONE) {
                int a = 3 * vertex(side);
                int b = 3 * vertex(next(side));
                middle[side] = positions.add(
                        (positions.get(a) + positions.get(b)) / 2,
                        (positions.get(a + 1) + positions.get(b + 1)) / 2,
                        (positions.get(a + 2) + positions.get(b + 2)) / 2);
                middle[mate[side]] = middle[side];
            }
        }
    }

    /** Splits a quadrilateral along its shorter diagonal, or as a fan from its first midpoint vertex if it has one. */
    private void cut(int q) {
        int[] ring = new int[8];
        int size = 0;
        int hub = NONE;
        for (int side = 4 * q; side < 4 * q + 4; side++) {
            ring[size++] = vertex(side);
            if (middle[side] != NONE) {
                hub = hub == NONE ? size : hub;
                ring[size++] = middle[side];
            }
        }
        if (hub == NONE) {
            hub = positions.squaredDistance(ring[0], ring[2]) <= positions.squaredDistance(ring[1], ring[3]) ? 0 : 1;
        }
        for (int i = 1; i + 1 < size; i++) {
            triangles.add(ring[hub]);
            triangles.add(ring[(hub + i) % size]);
            triangles.add(ring[(hub + i + 1) % size]);
        }
    }
}
