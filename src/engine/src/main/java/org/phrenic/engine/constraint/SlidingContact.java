package org.phrenic.engine.constraint;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SeparableConstraint;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Frictionless contact with a wall. A node beyond the wall is moved back along the wall's normal, and the normal
 * component of its velocity is replaced by that of the wall. Sliding and separation are free.
 *
 * <p>Adhering contact acts in both directions: the node slides along the wall but cannot leave it, however hard it is
 * pulled. The lung's surface behaves so on the pleura.
 *
 * <p>Each node caches a tangent plane of the wall, which moves with the wall's speed and is refreshed at an interval.
 * Between refreshes a node moves a fraction of a millimetre, so the plane is as accurate as the wall at a tenth of the
 * cost.
 */
public final class SlidingContact implements SeparableConstraint {
    private static final int PLANE = 5;
    private static final int NODES_A_PIECE = 512;
    /**
     * A node is far from the wall if its distance stays above this until the next refresh, at twice the speed of node
     * and wall, mm.
     */
    private static final double FAR_MM = 5;

    /**
     * Largest correction speed of a node in one-sided contact, mm/s: times the step it bounds the shift of each sweep.
     * It turns a sharp rotation of the wall or a deep penetration into a smooth return without a shock. A node without
     * other constraints is shifted once a step where constraints are projected by islands.
     */
    public static final double MAX_RETURN_SPEED = 100;

    /**
     * Largest correction speed of a node in adhering contact, mm/s, in each sweep as {@link #MAX_RETURN_SPEED}.
     * Ordinary corrections are slower. Where the wall has an edge, the plane next to a sliding node may lie tens of
     * millimetres away at the next refresh.
     */
    public static final double MAX_ADHERING_SPEED = 2000;

    /** Nodes times 3 in internal order, and their indices in the caller's list. */
    private final int[] node;

    private final int[] listed;
    private final ContactSurface surface;
    private final boolean adhering;
    private final double[] plane;
    private final boolean[] inContact;
    /** Nodes that cannot reach the wall before the next refresh. */
    private final boolean[] far;

    private double maxReturnSpeed;
    private ParticleSystem system;
    private final Workers.Task refreshTask = this::refreshPlanes;
    private final RefreshClock refresh;

    /**
     * @param layout layout of the system
     * @param callerNodes the contact nodes, caller's numbering
     * @param surface the wall
     * @param refreshInterval simulated time after which tangent planes are refreshed, s
     */
    public SlidingContact(NodeLayout layout, int[] callerNodes, ContactSurface surface, double refreshInterval) {
        this(layout, callerNodes, surface, refreshInterval, false);
    }

    /** Contact without separation; parameters as for the one-sided contact. */
    public static SlidingContact adhering(
            NodeLayout layout, int[] callerNodes, ContactSurface surface, double refreshInterval) {
        return new SlidingContact(layout, callerNodes, surface, refreshInterval, true);
    }

    private SlidingContact(
            NodeLayout layout, int[] callerNodes, ContactSurface surface, double refreshInterval, boolean adhering) {
        this.adhering = adhering;
        maxReturnSpeed = adhering ? MAX_ADHERING_SPEED : MAX_RETURN_SPEED;
        listed = layout.inMemoryOrder(callerNodes);
        node = Arrays.stream(listed)
                .map(i -> 3 * layout.internal(callerNodes[i]))
                .toArray();
        this.surface = surface;
        refresh = new RefreshClock(refreshInterval);
        plane = new double[PLANE * node.length];
        inContact = new boolean[node.length];
        far = new boolean[node.length];
    }

    /**
     * Sets the largest correction speed, mm/s. Use less than {@link #MAX_RETURN_SPEED} while a wall is being
     * introduced.
     */
    public void setMaxReturnSpeed(double speed) {
        maxReturnSpeed = speed;
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
        return new int[][] {node};
    }

    /** Number of nodes that the wall held in a sweep of the last step. */
    public int contactCount() {
        return (int) IntStream.range(0, node.length).filter(i -> inContact[i]).count();
    }

    @Override
    public boolean isContact() {
        return true;
    }

    @Override
    public void prepare(ParticleSystem particles, double time) {
        Arrays.fill(inContact, false);
        if (refresh.advanceTo(time)) {
            surface.prepare(time);
            system = particles;
            particles.workers().run((node.length + NODES_A_PIECE - 1) / NODES_A_PIECE, refreshTask);
        }
    }

    private void refreshPlanes(int piece) {
        double[] x = system.positions();
        double[] v = system.velocities();
        int to = Math.min(node.length, (piece + 1) * NODES_A_PIECE);
        for (int i = piece * NODES_A_PIECE; i < to; i++) {
            int n = node[i];
            int p = PLANE * i;
            surface.tangentPlane(listed[i], x[n], x[n + 1], x[n + 2], plane, p);
            double gap = gap(x, i);
            double speed = Math.sqrt(v[n] * v[n] + v[n + 1] * v[n + 1] + v[n + 2] * v[n + 2]) + Math.abs(plane[p + 4]);
            far[i] = !adhering && gap > FAR_MM + 2 * refresh.interval() * speed;
        }
    }

    @Override
    public int project(ParticleSystem particles, double h, int[] items, int from, int to, int[] moved) {
        double[] x = particles.positions();
        double[] v = particles.velocities();
        double[] w = particles.inverseMasses();
        double[] planes = plane;
        int[] nodes = node;
        double elapsed = refresh.elapsed();
        double farthest = maxReturnSpeed * h;
        int end = from;
        for (int k = from; k < to; k++) {
            int i = items[k];
            if (far[i]) {
                continue;
            }
            int n = nodes[i];
            int p = PLANE * i;
            double nx = planes[p];
            double ny = planes[p + 1];
            double nz = planes[p + 2];
            double wallSpeed = planes[p + 4];
            double gap = nx * x[n] + ny * x[n + 1] + nz * x[n + 2] - planes[p + 3] - wallSpeed * elapsed;
            boolean held = (adhering || gap < 0) && w[n / 3] > 0;
            if (held) {
                inContact[i] = true;
                moved[end++] = i;
                double shift = Math.max(-farthest, Math.min(farthest, gap));
                x[n] -= shift * nx;
                x[n + 1] -= shift * ny;
                x[n + 2] -= shift * nz;
                double into = nx * v[n] + ny * v[n + 1] + nz * v[n + 2] - wallSpeed;
                if (adhering || into < 0) {
                    v[n] -= into * nx;
                    v[n + 1] -= into * ny;
                    v[n + 2] -= into * nz;
                }
            }
        }
        return end - from;
    }

    @Override
    public void jacobianRows(ParticleSystem particles, RowConsumer out) {
        double[] x = particles.positions();
        double elapsed = refresh.elapsed();
        for (int i = 0; i < node.length; i++) {
            int p = PLANE * i;
            double gap = gap(x, i) - plane[p + 4] * elapsed;
            out.add(node[i] / 3, -1, plane[p], plane[p + 1], plane[p + 2], gap, !adhering);
        }
    }

    /** Distance of a node from its tangent plane when that was taken, mm. */
    private double gap(double[] x, int i) {
        int n = node[i];
        int p = PLANE * i;
        return plane[p] * x[n] + plane[p + 1] * x[n + 1] + plane[p + 2] * x[n + 2] - plane[p + 3];
    }

    /** Largest penetration of a tangent plane, mm. */
    @Override
    public double error(ParticleSystem particles) {
        double[] x = particles.positions();
        double worst = 0;
        double elapsed = refresh.elapsed();
        for (int i = 0; i < node.length; i++) {
            worst = Math.max(worst, plane[PLANE * i + 4] * elapsed - gap(x, i));
        }
        return worst;
    }
}
