package org.phrenic.engine.constraint;

import java.util.Arrays;
import org.phrenic.engine.Constraint;
import org.phrenic.engine.NodeLayout;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.Workers;

/**
 * Links of constant length between two nodes: the compression members of a tensegrity structure (Villard, Bourne and Bello 2009, eq. 5).
 *
 * <p>After a step that ignored the links, the ends A', B' of each are put back on the line A'B' at the link's length, the correction shared by inverse mass (so AA₁/AA' = BB₁/BB' for equal
 * masses), and velocities get the same shift over h, so that nothing heats. Links are coloured so that links of one colour share no node: a colour is done in parallel
 * with the same bits for any number of threads.
 *
 * <ul>
 *   <li>{@link #sweeping}: coloured Gauss-Seidel until the largest relative length error is below a tolerance (the default);
 *   <li>{@link #onceAsPublished}: one pass, in the order given, as the paper states.
 * </ul>
 */
public final class RigidLinks implements Constraint {
    private static final int LINKS_A_PIECE = 256;

    private final int[] nodeA;
    private final int[] nodeB;
    private final double[] length;
    private final int[] colourStart;
    private final double tolerance;
    private final int maxSweeps;
    private final boolean sequential;
    private final double[] pieceError;
    private int sweepsLast;

    private ParticleSystem system;
    private double inverseStep;
    private int colourFrom;
    private int colourTo;
    private final Workers.Task task = this::piece;

    private RigidLinks(
            NodeLayout layout,
            int[] callerA,
            int[] callerB,
            double[] callerPositions,
            double tolerance,
            int maxSweeps,
            boolean sequential) {
        int n = callerA.length;
        int[] a = new int[n];
        int[] b = new int[n];
        double[] l = new double[n];
        for (int i = 0; i < n; i++) {
            a[i] = layout.internal(callerA[i]);
            b[i] = layout.internal(callerB[i]);
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = callerPositions[3 * callerB[i] + axis] - callerPositions[3 * callerA[i] + axis];
                squared += d * d;
            }
            l[i] = Math.sqrt(squared);
            if (!(l[i] > 0)) {
                throw new IllegalArgumentException("rigid link " + i + " between nodes " + callerA[i] + " and "
                        + callerB[i] + ": found length " + l[i] + " mm, expected more than 0");
            }
        }
        int[] colour = sequential ? new int[n] : colours(a, b, layout.nodeCount());
        int colourCount = Arrays.stream(colour).max().orElse(-1) + 1;
        colourStart = new int[colourCount + 1];
        long[] key = new long[n];
        for (int i = 0; i < n; i++) {
            colourStart[colour[i] + 1]++;
            long place = sequential ? i : Math.min(a[i], b[i]);
            key[i] = (long) colour[i] << 56 | place << 28 | i;
        }
        for (int c = 0; c < colourCount; c++) {
            colourStart[c + 1] += colourStart[c];
        }
        Arrays.sort(key);
        nodeA = new int[n];
        nodeB = new int[n];
        length = new double[n];
        for (int i = 0; i < n; i++) {
            int from = (int) (key[i] & 0xfffffff);
            nodeA[i] = 3 * a[from];
            nodeB[i] = 3 * b[from];
            length[i] = l[from];
        }
        this.tolerance = tolerance;
        this.maxSweeps = maxSweeps;
        this.sequential = sequential;
        this.pieceError = new double[n / LINKS_A_PIECE + 1];
    }

    /**
     * Coloured Gauss-Seidel, the default.
     *
     * @param layout of the system they are for
     * @param nodeA one end of each link, caller's numbering
     * @param nodeB the other end
     * @param positions where lengths are taken, caller's order, mm
     * @param tolerance largest relative length error left over
     * @param maxSweeps at most so many sweeps a step
     * @throws IllegalArgumentException if a link has no length
     */
    public static RigidLinks sweeping(
            NodeLayout layout, int[] nodeA, int[] nodeB, double[] positions, double tolerance, int maxSweeps) {
        return new RigidLinks(layout, nodeA, nodeB, positions, tolerance, maxSweeps, false);
    }

    /** The paper's projection: each link once, in the order given. Parameters as for {@link #sweeping}. */
    public static RigidLinks onceAsPublished(NodeLayout layout, int[] nodeA, int[] nodeB, double[] positions) {
        return new RigidLinks(layout, nodeA, nodeB, positions, 0, 1, true);
    }

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

    public int count() {
        return length.length;
    }

    /** Colours, that is, parallel passes a sweep. */
    public int colourCount() {
        return colourStart.length - 1;
    }

    /** Sweeps that the last projection took. */
    public int sweepsLast() {
        return sweepsLast;
    }

    @Override
    public void project(ParticleSystem particles, double h) {
        system = particles;
        inverseStep = 1 / h;
        double worst = Double.POSITIVE_INFINITY;
        sweepsLast = 0;
        while (sweepsLast < maxSweeps && worst > tolerance) {
            worst = 0;
            for (int c = 0; c < colourStart.length - 1; c++) {
                colourFrom = colourStart[c];
                colourTo = colourStart[c + 1];
                int pieces = sequential ? 1 : (colourTo - colourFrom + LINKS_A_PIECE - 1) / LINKS_A_PIECE;
                particles.workers().run(pieces, task);
                for (int i = 0; i < pieces; i++) {
                    worst = Math.max(worst, pieceError[i]);
                }
            }
            sweepsLast++;
            // Links that share no node are exact after one pass: nothing can have moved them since.
            if (colourStart.length <= 2 && !sequential) {
                return;
            }
        }
    }

    private void piece(int piece) {
        int from = sequential ? colourFrom : colourFrom + piece * LINKS_A_PIECE;
        int to = sequential ? colourTo : Math.min(colourTo, from + LINKS_A_PIECE);
        double[] x = system.positions();
        double[] v = system.velocities();
        double[] w = system.inverseMasses();
        double worst = 0;
        for (int i = from; i < to; i++) {
            int a = nodeA[i];
            int b = nodeB[i];
            double wa = w[a / 3];
            double wb = w[b / 3];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double l = Math.sqrt(dx * dx + dy * dy + dz * dz);
            worst = Math.max(worst, Math.abs(l - length[i]) / length[i]);
            if (wa + wb == 0) {
                continue;
            }
            double s = (l - length[i]) / (l * (wa + wb));
            double sa = s * wa;
            double sb = s * wb;
            x[a] += sa * dx;
            x[a + 1] += sa * dy;
            x[a + 2] += sa * dz;
            x[b] -= sb * dx;
            x[b + 1] -= sb * dy;
            x[b + 2] -= sb * dz;
            sa *= inverseStep;
            sb *= inverseStep;
            v[a] += sa * dx;
            v[a + 1] += sa * dy;
            v[a + 2] += sa * dz;
            v[b] -= sb * dx;
            v[b + 1] -= sb * dy;
            v[b + 2] -= sb * dz;
        }
        pieceError[piece] = worst;
    }

    /** Largest relative length error |l - L| / L. */
    @Override
    public double error(ParticleSystem particles) {
        double[] x = particles.positions();
        double worst = 0;
        for (int i = 0; i < length.length; i++) {
            double dx = x[nodeB[i]] - x[nodeA[i]];
            double dy = x[nodeB[i] + 1] - x[nodeA[i] + 1];
            double dz = x[nodeB[i] + 2] - x[nodeA[i] + 2];
            double relative = Math.abs(Math.sqrt(dx * dx + dy * dy + dz * dz) - length[i]) / length[i];
            if (!(relative <= worst)) {
                worst = relative;
            }
        }
        return worst;
    }
}
