package org.phrenic.anatomy.contact;

import java.util.Arrays;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * Spreads the displacements of the vertices of an organ that yield to the diaphragm ({@link SheetContact}) over the
 * vertices about them, so that the organ is dented smoothly instead of vertex by vertex. With the displacements
 * {@code u} that vertices yield by, 0 for those that do not, the spread ones are, after {@value #PASSES} Jacobi sweeps
 * from u, those of
 *
 * <pre>
 * (a + n + {@value #DECAY}) d_i = a u_i + Σ d_j
 * </pre>
 *
 * over the n neighbours j of vertex i, where a is {@value #HOLD} for a vertex that yields and else 0. Vertices farther
 * than {@value #PASSES} edges from those that yield keep their places. Not thread-safe.
 */
final class YieldSpread {
    private static final int PASSES = 8;
    private static final double HOLD = 1;
    private static final double DECAY = 0.1;

    private final int[] start;
    private final int[] neighbours;
    private final int[] ring;
    private final int[] active;
    private final double[] yielded;
    private double[] spread;
    private double[] next;

    /** @param mesh the organ */
    YieldSpread(TriangleMesh mesh) {
        MeshTopology topology = new MeshTopology(mesh);
        int n = mesh.vertexCount();
        start = topology.vertexEdgeStart();
        neighbours = new int[topology.vertexEdges().length];
        for (int v = 0; v < n; v++) {
            for (int i = start[v]; i < start[v + 1]; i++) {
                neighbours[i] = topology.otherVertex(topology.vertexEdges()[i], v);
            }
        }
        ring = new int[n];
        active = new int[n];
        yielded = new double[3 * n];
        spread = new double[3 * n];
        next = new double[3 * n];
        Arrays.fill(ring, -1);
    }

    /**
     * Spreads the displacements from one set of positions to another.
     *
     * @param before positions before the organ yielded
     * @param after positions after it; changed in place
     * @return whether any vertex has yielded
     */
    boolean spread(double[] before, double[] after) {
        int count = findActive(before, after);
        if (count == 0) {
            return false;
        }
        for (int pass = 0; pass < PASSES; pass++) {
            for (int k = 0; k < count; k++) {
                relax(active[k]);
            }
            double[] swap = spread;
            spread = next;
            next = swap;
        }
        for (int k = 0; k < count; k++) {
            int v = 3 * active[k];
            for (int i = v; i < v + 3; i++) {
                after[i] = before[i] + spread[i];
                spread[i] = 0;
                next[i] = 0;
                yielded[i] = 0;
            }
            ring[active[k]] = -1;
        }
        return true;
    }

    /** Finds the vertices that yield and those about them, and the displacements of the first. */
    private int findActive(double[] before, double[] after) {
        int count = 0;
        for (int v = 0; v < ring.length; v++) {
            int i = 3 * v;
            if (after[i] != before[i] || after[i + 1] != before[i + 1] || after[i + 2] != before[i + 2]) {
                for (int j = i; j < i + 3; j++) {
                    yielded[j] = after[j] - before[j];
                    spread[j] = yielded[j];
                }
                ring[v] = 0;
                active[count++] = v;
            }
        }
        for (int k = 0; k < count; k++) {
            int v = active[k];
            for (int i = start[v]; i < start[v + 1] && ring[v] < PASSES; i++) {
                if (ring[neighbours[i]] < 0) {
                    ring[neighbours[i]] = ring[v] + 1;
                    active[count++] = neighbours[i];
                }
            }
        }
        return count;
    }

    private void relax(int v) {
        double hold = ring[v] == 0 ? HOLD : 0;
        double weight = hold + (start[v + 1] - start[v]) + DECAY;
        for (int axis = 0; axis < 3; axis++) {
            double sum = hold * yielded[3 * v + axis];
            for (int i = start[v]; i < start[v + 1]; i++) {
                sum += spread[3 * neighbours[i] + axis];
            }
            next[3 * v + axis] = sum / weight;
        }
    }
}
