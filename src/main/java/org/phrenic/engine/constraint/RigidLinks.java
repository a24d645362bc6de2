package org.phrenic.engine.constraint;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.IntStream;
import org.phrenic.engine.Constraint;
import org.phrenic.engine.NodeLayout;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.Workers;

/**
 * Links of constant length between two nodes: the compression members of a tensegrity structure (Villard, Bourne and Bello 2009, eq. 5).
 *
 * <p>After a step that ignored the links, the ends A', B' of each are brought back to the link's length, the correction shared by inverse mass (so AA₁/AA' = BB₁/BB' for equal
 * masses), and velocities get the same shift over h, so that nothing heats.
 *
 * <ul>
 *   <li>{@link #sweeping}, the default: coloured Gauss-Seidel until the largest relative length error is below a tolerance. Ends are shifted along the line AB that the link had
 *       before the step (SHAKE: Ryckaert, Ciccotti and Berendsen 1977, doi 10.1016/0021-9991(77)90098-5), which keeps angular momentum, the order 2 of velocity Verlet and
 *       the energy. Links of one colour share no node: a colour is done in parallel with the same bits for any number of threads;
 *   <li>{@link #onceAsPublished}: one pass, in the order given, along the line A'B', as the paper states. That direction belongs to the end of the step and takes energy out of links that
 *       turn: a link that turns at ω loses speed at the rate ω² h, so the scheme is of order 1.
 * </ul>
 */
public final class RigidLinks implements Constraint {
    private static final int LINKS_A_PIECE = DisjointLinks.SIZE;
    /** Cosine of the turn in one step beyond which the old line no longer serves as direction. */
    private static final double TURN = 0.9;
    /** Relative length error left after the last sweep that says that links contradict each other. */
    private static final double UNMET = 0.05;

    private final int[] nodeA;
    private final int[] nodeB;
    private final double[] length;
    private final double[] given;
    private final double[] caught;
    private final int[] colourStart;
    private final double tolerance;
    private final int maxSweeps;
    private final boolean asPublished;
    /** Whether the order matters: links that share no node give the same bits in any. */
    private final boolean inOrder;

    private final double[] pieceError;
    private int sweepsLast;

    private ParticleSystem system;
    private double step;
    private double inverseStep;
    private int colourFrom;
    private int colourTo;
    private double worstLast;
    private final Workers.Task task;
    private final Workers.Task velocityTask = this::velocityPiece;
    private final ThreadLocal<DisjointLinks> batches = ThreadLocal.withInitial(DisjointLinks::new);

    private RigidLinks(
            NodeLayout layout,
            int[] callerA,
            int[] callerB,
            double[] l,
            double tolerance,
            int maxSweeps,
            boolean asPublished) {
        int n = callerA.length;
        int[] a = new int[n];
        int[] b = new int[n];
        for (int i = 0; i < n; i++) {
            a[i] = layout.internal(callerA[i]);
            b[i] = layout.internal(callerB[i]);
            if (!(l[i] > 0)) {
                throw new IllegalArgumentException("rigid link " + i + " between nodes " + callerA[i] + " and "
                        + callerB[i] + ": found length " + l[i] + " mm, expected more than 0");
            }
        }
        inOrder = asPublished && shareNodes(a, b, layout.nodeCount());
        int[] colour = asPublished ? new int[n] : colours(a, b, layout.nodeCount());
        int colourCount = Arrays.stream(colour).max().orElse(-1) + 1;
        colourStart = new int[colourCount + 1];
        long[] key = new long[n];
        for (int i = 0; i < n; i++) {
            colourStart[colour[i] + 1]++;
            long place = inOrder ? i : Math.min(a[i], b[i]);
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
        given = length.clone();
        caught = length.clone();
        this.tolerance = tolerance;
        this.maxSweeps = maxSweeps;
        this.asPublished = asPublished;
        this.pieceError = new double[n / LINKS_A_PIECE + 1];
        this.task = asPublished && !inOrder ? this::disjointPiece : this::piece;
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
        return sweepingTo(layout, nodeA, nodeB, lengths(nodeA, nodeB, positions), tolerance, maxSweeps);
    }

    /** As {@link #sweeping}, with the length of each link given, mm. */
    public static RigidLinks sweepingTo(
            NodeLayout layout, int[] nodeA, int[] nodeB, double[] lengths, double tolerance, int maxSweeps) {
        return new RigidLinks(layout, nodeA, nodeB, lengths, tolerance, maxSweeps, false);
    }

    /** The paper's projection: each link once, in the order given. Parameters as for {@link #sweeping}. */
    public static RigidLinks onceAsPublished(NodeLayout layout, int[] nodeA, int[] nodeB, double[] positions) {
        return new RigidLinks(layout, nodeA, nodeB, lengths(nodeA, nodeB, positions), 0, 1, true);
    }

    private static double[] lengths(int[] nodeA, int[] nodeB, double[] positions) {
        double[] lengths = new double[nodeA.length];
        for (int i = 0; i < lengths.length; i++) {
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = positions[3 * nodeB[i] + axis] - positions[3 * nodeA[i] + axis];
                squared += d * d;
            }
            lengths[i] = Math.sqrt(squared);
        }
        return lengths;
    }

    private static boolean shareNodes(int[] a, int[] b, int nodes) {
        boolean[] used = new boolean[nodes];
        for (int i = 0; i < a.length; i++) {
            if (used[a[i]] || used[b[i]]) {
                return true;
            }
            used[a[i]] = true;
            used[b[i]] = true;
        }
        return false;
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

    /** Takes the links as long as they are now, to be brought to their given lengths by {@link #approach}: for links that were off for a while. */
    public void catchUp(ParticleSystem particles) {
        double[] x = particles.positions();
        for (int i = 0; i < caught.length; i++) {
            double dx = x[nodeB[i]] - x[nodeA[i]];
            double dy = x[nodeB[i] + 1] - x[nodeA[i] + 1];
            double dz = x[nodeB[i] + 2] - x[nodeA[i] + 2];
            caught[i] = Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        approach(0);
    }

    /** Sets every length between the one last caught (0) and the given one (1). */
    public void approach(double share) {
        for (int i = 0; i < length.length; i++) {
            length[i] = share == 1 ? given[i] : caught[i] + share * (given[i] - caught[i]);
        }
    }

    /** The nodes of the links in the caller's numbering: two a link. */
    public int[] callerPairs(NodeLayout layout) {
        int[] pairs = new int[2 * nodeA.length];
        for (int i = 0; i < nodeA.length; i++) {
            pairs[2 * i] = layout.caller(nodeA[i] / 3);
            pairs[2 * i + 1] = layout.caller(nodeB[i] / 3);
        }
        return pairs;
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
        step = h;
        inverseStep = 1 / h;
        double worst = Double.POSITIVE_INFINITY;
        sweepsLast = 0;
        while (sweepsLast < maxSweeps && worst > tolerance) {
            worst = 0;
            for (int c = 0; c < colourStart.length - 1; c++) {
                colourFrom = colourStart[c];
                colourTo = colourStart[c + 1];
                int pieces = inOrder ? 1 : (colourTo - colourFrom + LINKS_A_PIECE - 1) / LINKS_A_PIECE;
                particles.workers().run(pieces, task);
                for (int i = 0; i < pieces; i++) {
                    worst = Math.max(worst, pieceError[i]);
                }
            }
            sweepsLast++;
            // Links that share no node are exact after one pass: nothing can have moved them since.
            if (colourStart.length <= 2 && !inOrder) {
                worstLast = 0;
                return;
            }
        }
        worstLast = worst;
    }

    @Override
    public IntStream nodes() {
        return IntStream.concat(Arrays.stream(nodeA), Arrays.stream(nodeB));
    }

    @Override
    public void projectVelocities(ParticleSystem particles) {
        if (asPublished) {
            return;
        }
        system = particles;
        for (int sweep = 0; sweep < sweepsLast; sweep++) {
            for (int c = 0; c < colourStart.length - 1; c++) {
                colourFrom = colourStart[c];
                colourTo = colourStart[c + 1];
                particles.workers().run((colourTo - colourFrom + LINKS_A_PIECE - 1) / LINKS_A_PIECE, velocityTask);
            }
        }
    }

    /** Takes away the rate at which links lengthen, shared by inverse mass. */
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
            v[a] += sa * dx;
            v[a + 1] += sa * dy;
            v[a + 2] += sa * dz;
            v[b] -= sb * dx;
            v[b + 1] -= sb * dy;
            v[b + 2] -= sb * dz;
        }
    }

    /** Links that share nodes and after all sweeps are still off by more than a twentieth ask for what no shape has. */
    @Override
    public String unmet() {
        return asPublished || worstLast <= UNMET
                ? null
                : String.format(
                        Locale.ROOT,
                        "after %d sweeps a rigid link is still off its length by %.0f %%",
                        sweepsLast,
                        100 * worstLast);
    }

    /** Exact after one pass: its error is not asked for. */
    private void disjointPiece(int piece) {
        int from = piece * LINKS_A_PIECE;
        batches.get().project(system, step, nodeA, nodeB, length, from, Math.min(colourTo, from + LINKS_A_PIECE));
    }

    private void piece(int piece) {
        int from = inOrder ? colourFrom : colourFrom + piece * LINKS_A_PIECE;
        int to = inOrder ? colourTo : Math.min(colourTo, from + LINKS_A_PIECE);
        double[] x = system.positions();
        double[] v = system.velocities();
        double[] w = system.inverseMasses();
        int[] ends = nodeA;
        int[] otherEnds = nodeB;
        double[] lengths = length;
        double h = step;
        double perStep = inverseStep;
        boolean published = asPublished;
        double worst = 0;
        for (int i = from; i < to; i++) {
            int a = ends[i];
            int b = otherEnds[i];
            double rest = lengths[i];
            double wa = w[a / 3];
            double wb = w[b / 3];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double l = Math.sqrt(dx * dx + dy * dy + dz * dz);
            double over = l - rest;
            if (!(Math.abs(over) <= worst * rest)) {
                worst = Math.abs(over) / rest;
            }
            if (wa + wb == 0 || l == 0) {
                // Both ends given, or on one spot, where the line has no direction.
                continue;
            }
            double under = l;
            if (!published) {
                // Back by h v lies the line before the step; along it the impulse changes no angular momentum.
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
            }
            double s = over / (under * (wa + wb));
            double sa = s * wa;
            double sb = s * wb;
            x[a] += sa * dx;
            x[a + 1] += sa * dy;
            x[a + 2] += sa * dz;
            x[b] -= sb * dx;
            x[b + 1] -= sb * dy;
            x[b + 2] -= sb * dz;
            sa *= perStep;
            sb *= perStep;
            v[a] += sa * dx;
            v[a + 1] += sa * dy;
            v[a + 2] += sa * dz;
            v[b] -= sb * dx;
            v[b + 1] -= sb * dy;
            v[b + 2] -= sb * dz;
        }
        pieceError[piece] = worst;
    }

    @Override
    public void rows(ParticleSystem particles, Rows out) {
        double[] x = particles.positions();
        for (int i = 0; i < length.length; i++) {
            double dx = x[nodeA[i]] - x[nodeB[i]];
            double dy = x[nodeA[i] + 1] - x[nodeB[i] + 1];
            double dz = x[nodeA[i] + 2] - x[nodeB[i] + 2];
            double l = Math.sqrt(dx * dx + dy * dy + dz * dz);
            out.add(nodeA[i] / 3, nodeB[i] / 3, dx / l, dy / l, dz / l, l - length[i], false);
        }
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
            // The larger of a number and none is none, so that a lost position shows.
            worst = Math.max(worst, Math.abs(Math.sqrt(dx * dx + dy * dy + dz * dz) - length[i]) / length[i]);
        }
        return worst;
    }
}
