package org.phrenic.engine.constraint;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.engine.Constraint;
import org.phrenic.engine.NodeLayout;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.Workers;
import org.phrenic.geometry.Triangles;

/**
 * Pairs of nodes on the two faces of a thin sheet that may not change places: along the outer face's normal the outer node stays at least some distance in front of the inner one, (x_o - x_i)·n ≥ d. A strut between
 * them keeps their distance but not their order; with both, a sheet that is folded or pressed cannot turn inside out.
 *
 * <p>No node may be in two pairs. Where the order is broken both nodes are moved, the correction shared by inverse mass, and their speed toward each other is taken away. Normals are those of one triangle of
 * the outer face at the outer node, taken anew every few steps.
 */
public final class OrderedPairs implements Constraint {
    private static final int PAIRS_A_PIECE = 512;

    private final int[] outer;
    private final int[] inner;
    private final int[] triangle;
    private final double[] least;
    private final double[] normal;
    private final double[] fresh = new double[3];
    private final RefreshClock refresh;
    private ParticleSystem system;
    private final Workers.Task task = this::piece;

    /**
     * @param layout of the system it is for
     * @param outer the node of each pair that stays outside, caller's numbering
     * @param inner the other node
     * @param triangle three nodes a pair, a triangle of the outer face, anticlockwise seen from outside
     * @param least smallest distance along the normal, mm, one a pair
     * @param refreshInterval simulated time after which normals are taken anew, s
     */
    public OrderedPairs(
            NodeLayout layout, int[] outer, int[] inner, int[] triangle, double[] least, double refreshInterval) {
        int n = outer.length;
        if (inner.length != n || triangle.length != 3 * n || least.length != n) {
            throw new IllegalArgumentException("ordered pairs: found " + n + " outer nodes, " + inner.length
                    + " inner, "
                    + triangle.length + " corners and " + least.length + " distances, expected as many, as many, 3"
                    + " each and as many");
        }
        this.outer = new int[n];
        this.inner = new int[n];
        this.triangle = new int[3 * n];
        for (int i = 0; i < n; i++) {
            this.outer[i] = 3 * layout.internal(outer[i]);
            this.inner[i] = 3 * layout.internal(inner[i]);
            for (int c = 3 * i; c < 3 * i + 3; c++) {
                this.triangle[c] = 3 * layout.internal(triangle[c]);
            }
        }
        this.least = least.clone();
        this.refresh = new RefreshClock(refreshInterval);
        this.normal = new double[3 * n];
    }

    @Override
    public void setRefreshInterval(double seconds) {
        refresh.setInterval(seconds);
    }

    @Override
    public void forget() {
        refresh.forget();
    }

    @Override
    public IntStream nodes() {
        return IntStream.concat(Arrays.stream(outer), Arrays.stream(inner));
    }

    public int count() {
        return outer.length;
    }

    @Override
    public boolean isWall() {
        return true;
    }

    @Override
    public void prepare(double time) {
        refresh.goTo(time);
    }

    @Override
    public void project(ParticleSystem particles, double h) {
        system = particles;
        if (refresh.isDue()) {
            takeNormals(particles.positions());
        }
        particles.workers().run((outer.length + PAIRS_A_PIECE - 1) / PAIRS_A_PIECE, task);
    }

    private void takeNormals(double[] x) {
        for (int i = 0; i < normal.length; i += 3) {
            // A triangle that has no area for the moment keeps the normal it had.
            if (Triangles.normal(x, triangle[i], triangle[i + 1], triangle[i + 2], fresh) > 0) {
                System.arraycopy(fresh, 0, normal, i, 3);
            }
        }
    }

    private void piece(int piece) {
        double[] x = system.positions();
        double[] v = system.velocities();
        double[] w = system.inverseMasses();
        int to = Math.min(outer.length, (piece + 1) * PAIRS_A_PIECE);
        for (int i = piece * PAIRS_A_PIECE; i < to; i++) {
            int o = outer[i];
            int n = inner[i];
            double nx = normal[3 * i];
            double ny = normal[3 * i + 1];
            double nz = normal[3 * i + 2];
            double gap = nx * (x[o] - x[n]) + ny * (x[o + 1] - x[n + 1]) + nz * (x[o + 2] - x[n + 2]) - least[i];
            double wo = w[o / 3];
            double wn = w[n / 3];
            if (gap >= 0 || wo + wn == 0) {
                continue;
            }
            double so = wo / (wo + wn);
            double sn = wn / (wo + wn);
            move(x, o, n, -gap * so, gap * sn, nx, ny, nz);
            double closing = nx * (v[o] - v[n]) + ny * (v[o + 1] - v[n + 1]) + nz * (v[o + 2] - v[n + 2]);
            if (closing < 0) {
                move(v, o, n, -closing * so, closing * sn, nx, ny, nz);
            }
        }
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
    public void rows(ParticleSystem particles, Rows out) {
        double[] x = particles.positions();
        for (int i = 0; i < outer.length; i++) {
            double gap = -least[i];
            for (int axis = 0; axis < 3; axis++) {
                gap += normal[3 * i + axis] * (x[outer[i] + axis] - x[inner[i] + axis]);
            }
            out.add(outer[i] / 3, inner[i] / 3, normal[3 * i], normal[3 * i + 1], normal[3 * i + 2], gap, true);
        }
    }

    /** Largest breach of the least distance, mm, along the normals last taken. */
    @Override
    public double error(ParticleSystem particles) {
        double[] x = particles.positions();
        double worst = 0;
        for (int i = 0; i < outer.length; i++) {
            double gap = -least[i];
            for (int axis = 0; axis < 3; axis++) {
                gap += normal[3 * i + axis] * (x[outer[i] + axis] - x[inner[i] + axis]);
            }
            worst = Math.max(worst, -gap);
        }
        return worst;
    }
}
