package org.phrenic.engine.constraint;

import java.util.Arrays;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SeparableConstraint;
import org.phrenic.engine.math.Triangles;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Keeps pairs of nodes on the two faces of a thin sheet in order. Along the normal n of the outer face, the outer node
 * stays at least a distance d in front of the inner one, (x_o - x_i)·n ≥ d. A strut between the two keeps their
 * distance but not their order. With both, a folded or compressed sheet cannot invert.
 *
 * <p>No node may be in two pairs. Where a pair violates the constraint, both nodes are moved, the correction shared by
 * inverse mass, and their approach velocity is removed. They return no faster than
 * {@link SlidingContact#MAX_RETURN_SPEED}. The normal is the mean of the triangles about the outer node, weighted by
 * area and refreshed at an interval. In a fold single triangles turn over while the sheet as a whole does not; the mean
 * normal follows the sheet, so that pairs in a fold ask nothing that contact with a wall has to undo.
 */
public final class NonInversionPairs implements SeparableConstraint {
    private static final int PAIRS_A_PIECE = 256;

    private final int[] outer;
    private final int[] inner;
    /**
     * Corners of the triangles about the outer nodes, times 3; pair i has those from ringStart[i] to ringStart[i+1].
     */
    private final int[] ring;

    private final int[] ringStart;
    private final double[] minDistance;
    private final double[] normal;
    private final RefreshClock refresh;
    private final Workers.Task refreshTask = this::refreshNormals;
    private double[] position = {};

    /**
     * @param layout layout of the system
     * @param outer outer node of each pair, caller's numbering
     * @param inner inner node of each pair
     * @param rings corners of the triangles of the outer face at each outer node, three nodes a triangle, anticlockwise
     *     seen from outside
     * @param least smallest distance along the normal, mm, one a pair
     * @param refreshInterval simulated time after which normals are refreshed, s
     */
    public NonInversionPairs(
            NodeLayout layout, int[] outer, int[] inner, int[][] rings, double[] least, double refreshInterval) {
        int n = outer.length;
        if (inner.length != n || rings.length != n || least.length != n) {
            String found =
                    n + " outer nodes, " + inner.length + " inner, " + rings.length + " rings and " + least.length;
            throw new IllegalArgumentException(
                    "ordered pairs: found " + found + " distances, expected as many of each");
        }
        this.outer = new int[n];
        this.inner = new int[n];
        this.ringStart = new int[n + 1];
        this.minDistance = new double[n];
        int[] order = layout.inMemoryOrder(outer);
        for (int i = 0; i < n; i++) {
            int listed = order[i];
            this.outer[i] = 3 * layout.internal(outer[listed]);
            this.inner[i] = 3 * layout.internal(inner[listed]);
            this.ringStart[i + 1] = this.ringStart[i] + rings[listed].length;
            this.minDistance[i] = least[listed];
        }
        this.ring = Arrays.stream(order)
                .flatMap(listed -> Arrays.stream(rings[listed]))
                .map(node -> 3 * layout.internal(node))
                .toArray();
        this.refresh = new RefreshClock(refreshInterval);
        this.normal = new double[3 * n];
    }

    @Override
    public void setRefreshInterval(double seconds) {
        refresh.setInterval(seconds);
    }

    @Override
    public void invalidate() {
        refresh.invalidate();
    }

    @Override
    public int[][] itemNodes() {
        return new int[][] {outer, inner};
    }

    @Override
    public boolean isContact() {
        return true;
    }

    @Override
    public void prepare(ParticleSystem particles, double time) {
        if (refresh.advanceTo(time)) {
            position = particles.positions();
            particles.workers().run((outer.length + PAIRS_A_PIECE - 1) / PAIRS_A_PIECE, refreshTask);
        }
    }

    private void refreshNormals(int piece) {
        double[] x = position;
        double[] fresh = new double[3];
        int to = Math.min(outer.length, (piece + 1) * PAIRS_A_PIECE);
        for (int i = piece * PAIRS_A_PIECE; i < to; i++) {
            double nx = 0;
            double ny = 0;
            double nz = 0;
            for (int t = ringStart[i]; t < ringStart[i + 1]; t += 3) {
                double doubleArea = Triangles.normal(x, ring[t], ring[t + 1], ring[t + 2], fresh);
                nx += doubleArea * fresh[0];
                ny += doubleArea * fresh[1];
                nz += doubleArea * fresh[2];
            }
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            // A degenerate ring keeps its previous normal.
            if (length > 0) {
                normal[3 * i] = nx / length;
                normal[3 * i + 1] = ny / length;
                normal[3 * i + 2] = nz / length;
            }
        }
    }

    @Override
    public int project(ParticleSystem particles, double h, int[] items, int from, int to, int[] moved) {
        int end = from;
        double[] x = particles.positions();
        double[] v = particles.velocities();
        double[] w = particles.inverseMasses();
        double farthest = SlidingContact.MAX_RETURN_SPEED * h;
        for (int k = from; k < to; k++) {
            int i = items[k];
            int o = outer[i];
            int n = inner[i];
            double nx = normal[3 * i];
            double ny = normal[3 * i + 1];
            double nz = normal[3 * i + 2];
            double gap = nx * (x[o] - x[n]) + ny * (x[o + 1] - x[n + 1]) + nz * (x[o + 2] - x[n + 2]) - minDistance[i];
            double wo = w[o / 3];
            double wn = w[n / 3];
            if (gap >= 0 || wo + wn == 0) {
                continue;
            }
            moved[end++] = i;
            double so = wo / (wo + wn);
            double sn = wn / (wo + wn);
            double shift = Math.max(gap, -farthest);
            move(x, o, n, -shift * so, shift * sn, nx, ny, nz);
            double closing = nx * (v[o] - v[n]) + ny * (v[o + 1] - v[n + 1]) + nz * (v[o + 2] - v[n + 2]);
            if (closing < 0) {
                move(v, o, n, -closing * so, closing * sn, nx, ny, nz);
            }
        }
        return end - from;
    }

    private static void move(double[] a, int o, int n, double outward, double inward, double nx, double ny, double nz) {
        a[o] += outward * nx;
        a[o + 1] += outward * ny;
        a[o + 2] += outward * nz;
        a[n] += inward * nx;
        a[n + 1] += inward * ny;
        a[n + 2] += inward * nz;
    }

    @Override
    public void jacobianRows(ParticleSystem particles, RowConsumer out) {
        double[] x = particles.positions();
        for (int i = 0; i < outer.length; i++) {
            double gap = gap(x, i);
            out.add(outer[i] / 3, inner[i] / 3, normal[3 * i], normal[3 * i + 1], normal[3 * i + 2], gap, true);
        }
    }

    /** Distance of a pair along its last computed normal minus the least distance, mm. */
    private double gap(double[] x, int i) {
        double gap = -minDistance[i];
        for (int axis = 0; axis < 3; axis++) {
            gap += normal[3 * i + axis] * (x[outer[i] + axis] - x[inner[i] + axis]);
        }
        return gap;
    }

    /** Largest violation of the least distance, mm, along the last computed normals. */
    @Override
    public double error(ParticleSystem particles) {
        double[] x = particles.positions();
        double worst = 0;
        for (int i = 0; i < outer.length; i++) {
            worst = Math.max(worst, -gap(x, i));
        }
        return worst;
    }
}
