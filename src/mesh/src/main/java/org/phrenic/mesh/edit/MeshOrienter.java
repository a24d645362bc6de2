package org.phrenic.mesh.edit;

import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;

/** Consistent orientation of a surface by breadth-first search across manifold edges; see {@link MeshRepair#orient}. */
final class MeshOrienter {
    private final TriangleMesh mesh;
    private final EdgeTable edges;
    private final boolean[] done;
    private final boolean[] flip;
    /** Triangles of the current component in breadth-first order. */
    private final int[] queue;

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
        int flipped = 0;
        for (int seed = 0; seed < done.length; seed++) {
            flipped += done[seed] ? 0 : orientPiece(seed);
        }
        if (flipped == 0) {
            return new MeshRepair.Result(mesh, MeshRepair.Report.NONE);
        }
        int[] given = mesh.triangles();
        int[] t = given.clone();
        for (int i = 0; i < flip.length; i++) {
            if (flip[i]) {
                t[3 * i + 1] = given[3 * i + 2];
                t[3 * i + 2] = given[3 * i + 1];
            }
        }
        return new MeshRepair.Result(new TriangleMesh(mesh.positions(), t), new MeshRepair.Report(0, 0, 0, 0, flipped));
    }

    /** Orients the component of one triangle; returns the number of flipped triangles. */
    private int orientPiece(int seed) {
        int length = 1;
        queue[0] = seed;
        done[seed] = true;
        boolean closed = true;
        int flipped = 0;
        for (int head = 0; head < length; head++) {
            flipped += flip[queue[head]] ? 1 : 0;
            closed &= edges.isInteriorFace(queue[head]);
            length = orientNeighbours(queue[head], length);
        }
        boolean inverted = closed ? volume(length) < 0 : 2 * flipped > length;
        for (int k = 0; k < length; k++) {
            flip[queue[k]] ^= inverted;
        }
        return inverted ? length - flipped : flipped;
    }

    /** Appends the unvisited neighbours of a triangle to the queue, oriented like it. Returns the new queue length. */
    private int orientNeighbours(int triangle, int length) {
        int end = length;
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
                queue[end++] = other;
            }
        }
        return end;
    }

    /**
     * Six times the signed volume of the closed component in the queue. It is computed relative to the first corner,
     * which preserves precision far from the origin.
     */
    private double volume(int length) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        int o = 3 * t[3 * queue[0]];
        double sum = 0;
        for (int k = 0; k < length; k++) {
            int a = 3 * t[3 * queue[k]];
            int b = 3 * t[3 * queue[k] + 1];
            int c = 3 * t[3 * queue[k] + 2];
            double bx = p[b] - p[o];
            double by = p[b + 1] - p[o + 1];
            double bz = p[b + 2] - p[o + 2];
            double cx = p[c] - p[o];
            double cy = p[c + 1] - p[o + 1];
            double cz = p[c + 2] - p[o + 2];
            double six = (p[a] - p[o]) * (by * cz - bz * cy)
                    + (p[a + 1] - p[o + 1]) * (bz * cx - bx * cz)
                    + (p[a + 2] - p[o + 2]) * (bx * cy - by * cx);
            sum += flip[queue[k]] ? -six : six;
        }
        return sum;
    }
}
