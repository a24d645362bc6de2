package org.phrenic.engine.constraint;

import java.util.Arrays;
import java.util.function.IntToLongFunction;
import java.util.stream.IntStream;
import org.phrenic.engine.CoupledConstraint;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.math.DenseVectors;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * Links of constant length between two nodes: the compression members of a tensegrity structure (Villard, Bourne and
 * Bello 2009, eq. 5).
 *
 * <p>After an unconstrained step, the ends A', B' of each link are moved back to the link's length. The correction is
 * shared by inverse mass (so AA₁/AA' = BB₁/BB' for equal masses). Velocities are corrected by the same displacement
 * divided by h, so that the projection adds no energy.
 *
 * <ul>
 *   <li>{@link #gaussSeidel}, the default: coloured Gauss-Seidel sweeps until the largest relative length error is
 *       below a tolerance. Corrections act along the direction AB of the link before the step (SHAKE: Ryckaert,
 *       Ciccotti and Berendsen 1977, doi 10.1016/0021-9991(77)90098-5). This conserves angular momentum and energy and
 *       keeps the order 2 of velocity Verlet. Links of one colour share no node, so a colour is projected in parallel
 *       with bitwise identical results for any number of threads;
 *   <li>{@link #singlePass}: one pass in the given order along A'B', as the paper states. This direction belongs to the
 *       end of the step and dissipates energy of rotating links: a link that rotates at ω loses speed at the rate ω² h,
 *       so the scheme is of order 1.
 * </ul>
 */
public abstract sealed class RigidLinks implements CoupledConstraint permits GaussSeidelLinks, SinglePassLinks {
    static final int LINKS_A_PIECE = 256;

    /** First and second node of each link times 3, internal order. */
    final int[] nodeA;

    final int[] nodeB;
    /** Current link lengths, mm. */
    final double[] length;

    private final double[] targetLength;
    private final double[] capturedLength;

    /** Ends of links as internal nodes in the caller's order of links; {@code order} is the order of projection. */
    RigidLinks(int[] a, int[] b, double[] l, int[] order) {
        int n = order.length;
        nodeA = new int[n];
        nodeB = new int[n];
        length = new double[n];
        for (int i = 0; i < n; i++) {
            nodeA[i] = 3 * a[order[i]];
            nodeB[i] = 3 * b[order[i]];
            length[i] = l[order[i]];
        }
        targetLength = length.clone();
        capturedLength = length.clone();
    }

    /**
     * Links projected by coloured Gauss-Seidel sweeps, the default.
     *
     * @param layout layout of the system
     * @param nodeA one end of each link, caller's numbering
     * @param nodeB the other end
     * @param positions positions that define the lengths, caller's order, mm
     * @param tolerance largest relative length error after the sweeps
     * @param maxSweeps maximum number of sweeps a step
     * @throws IllegalArgumentException if a link has zero length
     */
    public static RigidLinks gaussSeidel(
            NodeLayout layout, int[] nodeA, int[] nodeB, double[] positions, double tolerance, int maxSweeps) {
        double[] lengths = DenseVectors.distances(positions, nodeA, nodeB);
        return gaussSeidelToLengths(layout, nodeA, nodeB, lengths, tolerance, maxSweeps);
    }

    /** As {@link #gaussSeidel}, with the length of each link given, mm. */
    public static RigidLinks gaussSeidelToLengths(
            NodeLayout layout, int[] nodeA, int[] nodeB, double[] lengths, double tolerance, int maxSweeps) {
        return new GaussSeidelLinks(layout, nodeA, nodeB, lengths, tolerance, maxSweeps);
    }

    /** The paper's projection: each link once, in the given order. Parameters as for {@link #gaussSeidel}. */
    public static RigidLinks singlePass(NodeLayout layout, int[] nodeA, int[] nodeB, double[] positions) {
        return new SinglePassLinks(layout, nodeA, nodeB, DenseVectors.distances(positions, nodeA, nodeB));
    }

    /** Internal numbers of one end of each link. */
    static int[] internal(NodeLayout layout, int[] callerNodes) {
        return Arrays.stream(callerNodes).map(layout::internal).toArray();
    }

    /** @throws IllegalArgumentException if a link has zero length or joins a node to itself */
    static void checkLengths(int[] callerA, int[] callerB, double[] l) {
        for (int i = 0; i < l.length; i++) {
            if (callerA[i] == callerB[i]) {
                throw new IllegalArgumentException(
                        "rigid link " + i + ": found node " + callerA[i] + " at both ends, expected two nodes");
            }
            if (!(l[i] > 0)) {
                throw new IllegalArgumentException("rigid link " + i + " between nodes " + callerA[i] + " and "
                        + callerB[i] + ": found length " + l[i] + " mm, expected more than 0");
            }
        }
    }

    /** Link numbers sorted by a key whose lowest 28 bits are free for the link number. */
    static int[] sorted(int n, IntToLongFunction key) {
        return IntStream.range(0, n)
                .mapToLong(i -> key.applyAsLong(i) | i)
                .sorted()
                .mapToInt(each -> (int) (each & 0xfffffff))
                .toArray();
    }

    /**
     * Sets the links to their current lengths. {@link #interpolateLengths} then brings them to their target lengths.
     * For links that were disabled for a while.
     */
    public void captureLengths(ParticleSystem particles) {
        double[] x = particles.positions();
        for (int i = 0; i < capturedLength.length; i++) {
            capturedLength[i] = currentLength(x, i);
        }
        interpolateLengths(0);
    }

    private double currentLength(double[] x, int i) {
        double dx = x[nodeB[i]] - x[nodeA[i]];
        double dy = x[nodeB[i] + 1] - x[nodeA[i] + 1];
        double dz = x[nodeB[i] + 2] - x[nodeA[i] + 2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /** Interpolates every length between the last captured one (0) and the target (1). */
    public void interpolateLengths(double share) {
        for (int i = 0; i < length.length; i++) {
            length[i] =
                    share == 1 ? targetLength[i] : capturedLength[i] + share * (targetLength[i] - capturedLength[i]);
        }
    }

    /** The nodes of the links in the caller's numbering, two a link. */
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

    /** Adds sa d to node a of u and subtracts sb d from node b. */
    static void applyImpulse(double[] u, int a, int b, double sa, double sb, double dx, double dy, double dz) {
        u[a] += sa * dx;
        u[a + 1] += sa * dy;
        u[a + 2] += sa * dz;
        u[b] -= sb * dx;
        u[b + 1] -= sb * dy;
        u[b + 2] -= sb * dz;
    }

    /** Number of sweeps of the last projection. */
    public abstract int lastSweepCount();

    @Override
    public void jacobianRows(ParticleSystem particles, RowConsumer out) {
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
            // Math.max propagates NaN, so that invalid positions are reported.
            worst = Math.max(worst, Math.abs(currentLength(x, i) - length[i]) / length[i]);
        }
        return worst;
    }
}
