package org.phrenic.mesh.edit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;

/**
 * Consistent orientation of a surface by breadth-first search across manifold edges, and of closed components by which
 * of them lie within others; see {@link MeshRepair#orient}.
 */
final class MeshOrienter {
    private final TriangleMesh mesh;
    private final EdgeTable edges;
    private final boolean[] done;
    private final boolean[] flip;
    /** Triangles in breadth-first order, component after component. */
    private final int[] queue;

    private int queued;
    private final List<int[]> shells = new ArrayList<>();

    private MeshOrienter(TriangleMesh mesh, EdgeTable edges) {
        this.mesh = mesh;
        this.edges = edges;
        done = new boolean[mesh.triangleCount()];
        flip = new boolean[done.length];
        queue = new int[done.length];
    }

    /**
     * The consistently oriented mesh and the number of flipped triangles. {@code edges} is the edge table of the mesh.
     */
    static MeshRepair.Result orient(TriangleMesh mesh, EdgeTable edges) {
        return new MeshOrienter(mesh, edges).run();
    }

    private MeshRepair.Result run() {
        for (int seed = 0; seed < done.length; seed++) {
            if (!done[seed]) {
                orientPiece(seed);
            }
        }
        if (shells.size() > 1) {
            NestedShells.cavities(turned(), shells).forEach(this::turn);
        }
        int flipped = 0;
        for (boolean turned : flip) {
            flipped += turned ? 1 : 0;
        }
        return new MeshRepair.Result(turned(), new MeshRepair.Report(0, 0, 0, 0, flipped));
    }

    /** The mesh with the triangles flipped that are to be; itself if there are none. */
    private TriangleMesh turned() {
        int[] given = mesh.triangles();
        int[] t = given;
        for (int i = 0; i < flip.length; i++) {
            if (flip[i]) {
                t = t == given ? given.clone() : t;
                t[3 * i + 1] = given[3 * i + 2];
                t[3 * i + 2] = given[3 * i + 1];
            }
        }
        return t == given ? mesh : new TriangleMesh(mesh.positions(), t);
    }

    /** Orients the component of one triangle. */
    private void orientPiece(int seed) {
        int start = queued;
        queue[queued++] = seed;
        done[seed] = true;
        boolean closed = true;
        int flipped = 0;
        for (int head = start; head < queued; head++) {
            flipped += flip[queue[head]] ? 1 : 0;
            closed &= edges.isInteriorFace(queue[head]);
            orientNeighbours(queue[head]);
        }
        int[] piece = Arrays.copyOfRange(queue, start, queued);
        if (closed ? volume(piece) < 0 : 2 * flipped > piece.length) {
            turn(piece);
        }
        if (closed) {
            shells.add(piece);
        }
    }

    private void turn(int[] piece) {
        for (int triangle : piece) {
            flip[triangle] ^= true;
        }
    }

    /** Appends the unvisited neighbours of a triangle to the queue, oriented like it. */
    private void orientNeighbours(int triangle) {
        int[] t = mesh.triangles();
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            int edge = edges.edgeOfSide()[side];
            if (edge == EdgeTable.NONE || edges.faceCount(edge) != 2) {
                continue;
            }
            int first = edges.sides()[edges.start(edge)];
            int opposite = first == side ? edges.sides()[edges.start(edge) + 1] : first;
            int other = opposite / 3;
            if (!done[other]) {
                done[other] = true;
                flip[other] = flip[triangle] ^ t[opposite] == t[side];
                queue[queued++] = other;
            }
        }
    }

    /**
     * Six times the signed volume of a closed component. It is computed relative to the first corner, which preserves
     * precision far from the origin.
     */
    private double volume(int[] piece) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        int o = 3 * t[3 * piece[0]];
        double sum = 0;
        for (int triangle : piece) {
            int a = 3 * t[3 * triangle];
            int b = 3 * t[3 * triangle + 1];
            int c = 3 * t[3 * triangle + 2];
            double bx = p[b] - p[o];
            double by = p[b + 1] - p[o + 1];
            double bz = p[b + 2] - p[o + 2];
            double cx = p[c] - p[o];
            double cy = p[c + 1] - p[o + 1];
            double cz = p[c + 2] - p[o + 2];
            double six = (p[a] - p[o]) * (by * cz - bz * cy)
                    + (p[a + 1] - p[o + 1]) * (bz * cx - bx * cz)
                    + (p[a + 2] - p[o + 2]) * (bx * cy - by * cx);
            sum += flip[triangle] ? -six : six;
        }
        return sum;
    }
}
