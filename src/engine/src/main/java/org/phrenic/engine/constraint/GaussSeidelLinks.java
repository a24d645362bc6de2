package org.phrenic.engine.constraint;

import java.util.Arrays;
import java.util.Locale;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SeparableConstraint;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Rigid links projected by coloured Gauss-Seidel sweeps until the largest error is below a tolerance. Corrections act
 * along the directions of the links before the step. Links of one colour share no node. With a single colour, one sweep
 * is exact.
 */
final class GaussSeidelLinks extends RigidLinks implements SeparableConstraint {
    /** Cosine of the rotation in one step beyond which the old direction is not used. */
    private static final double TURN = 0.9;
    /** Relative length error after the last sweep above which the links are considered contradictory. */
    private static final double UNMET = 0.05;

    private final int[] colourStart;
    private final double tolerance;
    private final int maxSweeps;
    private final double[] pieceError;
    private int sweepsLast;
    private double lastError;

    private ParticleSystem system;
    private double step;
    private double inverseStep;
    private int colourFrom;
    private int colourTo;
    private final Workers.Task task = this::piece;
    private final Workers.Task velocityTask = this::velocityPiece;

    GaussSeidelLinks(NodeLayout layout, int[] callerA, int[] callerB, double[] l, double tolerance, int maxSweeps) {
        this(internal(layout, callerA), internal(layout, callerB), l, layout.nodeCount(), tolerance, maxSweeps);
        checkLengths(callerA, callerB, l);
    }

    private GaussSeidelLinks(int[] a, int[] b, double[] l, int nodes, double tolerance, int maxSweeps) {
        this(a, b, l, colours(a, b, nodes), tolerance, maxSweeps);
    }

    private GaussSeidelLinks(int[] a, int[] b, double[] l, int[] colour, double tolerance, int maxSweeps) {
        super(a, b, l, sorted(a.length, i -> (long) colour[i] << 56 | (long) Math.min(a[i], b[i]) << 28));
        int colourCount = Arrays.stream(colour).max().orElse(-1) + 1;
        colourStart = new int[colourCount + 1];
        for (int each : colour) {
            colourStart[each + 1]++;
        }
        Arrays.parallelPrefix(colourStart, Integer::sum);
        this.tolerance = tolerance;
        this.maxSweeps = maxSweeps;
        pieceError = new double[a.length / LINKS_A_PIECE + 1];
    }

    /**
     * Greedy colouring in which no two links of one colour share a node: each link gets the lowest colour free at both
     * ends.
     */
    private static int[] colours(int[] a, int[] b, int nodes) {
        long[] used = new long[nodes];
        int[] colour = new int[a.length];
        for (int i = 0; i < a.length; i++) {
            long free = ~(used[a[i]] | used[b[i]]);
            if (free == 0) {
                throw new IllegalArgumentException("rigid links: found more than 64 at one node, expected fewer");
            }
            colour[i] = Long.numberOfTrailingZeros(free);
            used[a[i]] |= 1L << colour[i];
            used[b[i]] |= 1L << colour[i];
        }
        return colour;
    }

    @Override
    public int lastSweepCount() {
        return sweepsLast;
    }

    @Override
    public boolean isSeparable() {
        return colourStart.length <= 2;
    }

    @Override
    public int[][] itemNodes() {
        return new int[][] {nodeA, nodeB};
    }

    @Override
    public void prepare(ParticleSystem particles, double time) {
        if (isSeparable()) {
            sweepsLast = 1;
        }
    }

    @Override
    public int project(ParticleSystem particles, double h, int[] items, int from, int to, int[] moved) {
        double[] x = particles.positions();
        double[] v = particles.velocities();
        double[] w = particles.inverseMasses();
        for (int i = from; i < to; i++) {
            restore(items[i], x, v, w, h, 1 / h);
        }
        System.arraycopy(items, from, moved, from, to - from);
        return to - from;
    }

    @Override
    public void project(ParticleSystem particles, double h) {
        system = particles;
        step = h;
        inverseStep = 1 / h;
        double worst = Double.POSITIVE_INFINITY;
        sweepsLast = 0;
        while (sweepsLast < maxSweeps && worst > tolerance) {
            worst = 0;
            for (int c = 0; c < colourStart.length - 1; c++) {
                int pieces = pieces(c);
                particles.workers().run(pieces, task);
                for (int i = 0; i < pieces; i++) {
                    worst = Math.max(worst, pieceError[i]);
                }
            }
            sweepsLast++;
            if (isSeparable()) {
                worst = 0;
            }
        }
        lastError = worst;
    }

    @Override
    public void projectVelocities(ParticleSystem particles) {
        system = particles;
        for (int sweep = 0; sweep < sweepsLast; sweep++) {
            for (int c = 0; c < colourStart.length - 1; c++) {
                particles.workers().run(pieces(c), velocityTask);
            }
        }
    }

    /** Selects a colour and returns the number of pieces of work for it. */
    private int pieces(int colour) {
        colourFrom = colourStart[colour];
        colourTo = colourStart[colour + 1];
        return (colourTo - colourFrom + LINKS_A_PIECE - 1) / LINKS_A_PIECE;
    }

    private void piece(int piece) {
        int from = colourFrom + piece * LINKS_A_PIECE;
        int to = Math.min(colourTo, from + LINKS_A_PIECE);
        double[] x = system.positions();
        double[] v = system.velocities();
        double[] w = system.inverseMasses();
        double h = step;
        double perStep = inverseStep;
        double worst = 0;
        for (int i = from; i < to; i++) {
            double error = restore(i, x, v, w, h, perStep);
            if (!(error <= worst)) {
                worst = error;
            }
        }
        pieceError[piece] = worst;
    }

    /** Projects a link to its length; returns its relative error before. */
    private double restore(int i, double[] x, double[] v, double[] w, double h, double perStep) {
        int a = nodeA[i];
        int b = nodeB[i];
        double rest = length[i];
        double wa = w[a / 3];
        double wb = w[b / 3];
        double dx = x[b] - x[a];
        double dy = x[b + 1] - x[a + 1];
        double dz = x[b + 2] - x[a + 2];
        double l = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double over = l - rest;
        double error = Math.abs(over) / rest;
        if (wa + wb == 0 || l == 0) {
            // Both ends prescribed, or coincident ends, which define no direction.
            return error;
        }
        double under = l;
        // Subtracting h v gives the direction before the step. An impulse along it conserves angular momentum.
        double ox = dx - h * (v[b] - v[a]);
        double oy = dy - h * (v[b + 1] - v[a + 1]);
        double oz = dz - h * (v[b + 2] - v[a + 2]);
        double along = dx * ox + dy * oy + dz * oz;
        double squared = ox * ox + oy * oy + oz * oz;
        double more = over * (l + rest);
        double root = along * along - squared * more;
        if (along > TURN * l * Math.sqrt(squared) && root > 0) {
            // |d - t o| = L: t = over / under is the smaller root.
            over = more;
            under = along + Math.sqrt(root);
            dx = ox;
            dy = oy;
            dz = oz;
        }
        double s = over / (under * (wa + wb));
        double sa = s * wa;
        double sb = s * wb;
        applyImpulse(x, a, b, sa, sb, dx, dy, dz);
        applyImpulse(v, a, b, sa * perStep, sb * perStep, dx, dy, dz);
        return error;
    }

    /** Removes the rate of change of link lengths, shared by inverse mass. */
    private void velocityPiece(int piece) {
        int from = colourFrom + piece * LINKS_A_PIECE;
        int to = Math.min(colourTo, from + LINKS_A_PIECE);
        double[] x = system.positions();
        double[] v = system.velocities();
        double[] w = system.inverseMasses();
        for (int i = from; i < to; i++) {
            int a = nodeA[i];
            int b = nodeB[i];
            double wa = w[a / 3];
            double wb = w[b / 3];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double under = (dx * dx + dy * dy + dz * dz) * (wa + wb);
            if (under == 0) {
                continue;
            }
            double rate = dx * (v[b] - v[a]) + dy * (v[b + 1] - v[a + 1]) + dz * (v[b + 2] - v[a + 2]);
            double sa = rate / under * wa;
            double sb = rate / under * wb;
            applyImpulse(v, a, b, sa, sb, dx, dy, dz);
        }
    }

    /** Reports coupled links with a relative error above 5 % after all sweeps: their lengths are incompatible. */
    @Override
    public String violation() {
        String pattern = "after %d sweeps a rigid link is still off its length by %.0f %%";
        return lastError <= UNMET ? null : String.format(Locale.ROOT, pattern, sweepsLast, 100 * lastError);
    }
}
