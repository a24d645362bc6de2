package org.phrenic.mesh.edit;

import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;

/**
 * Turns the triangles of a surface to one side: from a first triangle of each piece on, its neighbours across manifold
 * edges are brought to agree with it; then the whole piece is turned if it faces inward (closed) or if that leaves more
 * of its triangles as they were (open).
 */
final class MeshOrienter {
    private MeshOrienter() {}

    /**
     * Turns the triangles; see {@link MeshRepair#orient}.
     *
     * @param edges of the mesh
     */
    static MeshRepair.Result orient(TriangleMesh mesh, EdgeTable edges) {
        int[] given = mesh.triangles();
        int count = mesh.triangleCount();
        boolean[] done = new boolean[count];
        boolean[] flip = new boolean[count];
        int[] queue = new int[count];
        int flipped = 0;
        for (int seed = 0; seed < count; seed++) {
            if (done[seed]) {
                continue;
            }
            int head = 0;
            int tail = 0;
            queue[tail++] = seed;
            done[seed] = true;
            boolean closed = true;
            int turned = 0;
            while (head < tail) {
                int triangle = queue[head++];
                turned += flip[triangle] ? 1 : 0;
                closed &= edges.isInteriorTriangle(triangle);
                tail = orientNeighbours(edges, given, triangle, done, flip, queue, tail);
            }
            boolean inverted = closed ? volume(mesh, queue, tail, flip) < 0 : 2 * turned > tail;
            for (int k = 0; k < tail; k++) {
                flip[queue[k]] ^= inverted;
            }
            flipped += inverted ? tail - turned : turned;
        }
        if (flipped == 0) {
            return new MeshRepair.Result(mesh, MeshRepair.Report.NONE);
        }
        int[] t = given.clone();
        for (int i = 0; i < count; i++) {
            if (flip[i]) {
                t[3 * i + 1] = given[3 * i + 2];
                t[3 * i + 2] = given[3 * i + 1];
            }
        }
        return new MeshRepair.Result(
                new TriangleMesh(mesh.positions(), t), new MeshRepair.Report(0, 0, 0, 0, flipped, 0));
    }

    /**
     * Enters the neighbours of a triangle that are not done yet, turned to its side, into the queue; returns the
     * queue's new end.
     */
    private static int orientNeighbours(
            EdgeTable edges, int[] t, int triangle, boolean[] done, boolean[] flip, int[] queue, int queueEnd) {
        int end = queueEnd;
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            int edge = edges.triangleEdges[side];
            if (edge == EdgeTable.NONE || edges.edgeTriangleCount[edge] != 2) {
                continue;
            }
            int other = edges.otherTriangle(edge, triangle);
            if (!done[other]) {
                done[other] = true;
                flip[other] = flip[triangle] ^ runsAlong(t, other, t[side], t[EdgeTable.next(side)]);
                queue[end++] = other;
            }
        }
        return end;
    }

    private static boolean runsAlong(int[] t, int triangle, int from, int to) {
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            if (t[side] == from && t[EdgeTable.next(side)] == to) {
                return true;
            }
        }
        return false;
    }

    /** Signed volume of one closed piece about its first corner, which loses no digits far from the origin. */
    private static double volume(TriangleMesh mesh, int[] piece, int length, boolean[] flip) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        int o = 3 * t[3 * piece[0]];
        double sum = 0;
        for (int k = 0; k < length; k++) {
            int a = 3 * t[3 * piece[k]];
            int b = 3 * t[3 * piece[k] + 1];
            int c = 3 * t[3 * piece[k] + 2];
            double bx = p[b] - p[o];
            double by = p[b + 1] - p[o + 1];
            double bz = p[b + 2] - p[o + 2];
            double cx = p[c] - p[o];
            double cy = p[c + 1] - p[o + 1];
            double cz = p[c + 2] - p[o + 2];
            double six = (p[a] - p[o]) * (by * cz - bz * cy)
                    + (p[a + 1] - p[o + 1]) * (bz * cx - bx * cz)
                    + (p[a + 2] - p[o + 2]) * (bx * cy - by * cx);
            sum += flip[piece[k]] ? -six : six;
        }
        return sum;
    }
}
