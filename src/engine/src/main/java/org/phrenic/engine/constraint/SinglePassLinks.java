package org.phrenic.engine.constraint;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Rigid links projected once, along their direction A'B' at the end of the step. Links that share nodes are projected
 * in the given order, independent links in parallel.
 */
final class SinglePassLinks extends RigidLinks {
    /** Whether links share nodes, so that the order affects the result. */
    private final boolean inOrder;

    private ParticleSystem system;
    private double step;
    private final Workers.Task disjointTask = this::disjointPiece;

    SinglePassLinks(NodeLayout layout, int[] callerA, int[] callerB, double[] l) {
        this(internal(layout, callerA), internal(layout, callerB), l, layout.nodeCount());
        checkLengths(callerA, callerB, l);
    }

    private SinglePassLinks(int[] a, int[] b, double[] l, int nodes) {
        this(a, b, l, shareNodes(a, b, nodes));
    }

    private SinglePassLinks(int[] a, int[] b, double[] l, boolean inOrder) {
        super(a, b, l, sorted(a.length, i -> inOrder ? (long) i << 28 : (long) Math.min(a[i], b[i]) << 28));
        this.inOrder = inOrder;
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

    @Override
    public int lastSweepCount() {
        return 1;
    }

    @Override
    public void project(ParticleSystem particles, double h) {
        if (inOrder) {
            project(particles, 1 / h, 0, length.length);
            return;
        }
        system = particles;
        step = h;
        particles.workers().run((length.length + LINKS_A_PIECE - 1) / LINKS_A_PIECE, disjointTask);
    }

    private void disjointPiece(int piece) {
        int from = piece * LINKS_A_PIECE;
        project(system, 1 / step, from, Math.min(length.length, from + LINKS_A_PIECE));
    }

    private void project(ParticleSystem particles, double perStep, int from, int to) {
        double[] x = particles.positions();
        double[] v = particles.velocities();
        double[] w = particles.inverseMasses();
        for (int i = from; i < to; i++) {
            int a = nodeA[i];
            int b = nodeB[i];
            double wa = w[a / 3];
            double wb = w[b / 3];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double l = Math.sqrt(dx * dx + dy * dy + dz * dz);
            if (wa + wb == 0 || l == 0) {
                // Both ends prescribed, or coincident ends, which define no direction.
                continue;
            }
            double s = (l - length[i]) / (l * (wa + wb));
            double sa = s * wa;
            double sb = s * wb;
            applyImpulse(x, a, b, sa, sb, dx, dy, dz);
            applyImpulse(v, a, b, sa * perStep, sb * perStep, dx, dy, dz);
        }
    }
}
