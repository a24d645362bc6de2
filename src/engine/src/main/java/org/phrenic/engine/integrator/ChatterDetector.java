package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.Workers;

/**
 * Detects numerical oscillation (chatter) that the stability limit of the initial scene cannot predict: links under
 * load, pressure or large stretch can make the scene too stiff for the step. Beyond its limit a scheme oscillates at
 * the highest frequency, with a phase advance of about 180 degrees a substep (RK4: 110 degrees), while physical motion
 * is smooth over many steps.
 *
 * <p>A node chatters if it is faster than 20 mm/s and its velocity reverses in at least 14 of 16 successive substeps
 * (RK4: 20 of 32). Nodes that collide with walls also reverse, but not in every substep. The search for a candidate
 * node runs only in every sixteenth substep, which limits its cost to a few copies of the velocities.
 */
final class ChatterDetector {
    private static final int PERIOD = 16;
    /**
     * Threshold of |u - v|² / (|u|² + |v|²) for a reversal. The ratio is 0 for equal, 1 for orthogonal, 2 for opposite
     * velocities.
     */
    private static final double TURN = 1.2;
    /** Lowest speed of a chattering node, mm/s: that of the dome in quiet breathing. */
    private static final double SPEED = 20;

    private static final int NONE = -1;
    /** Number of substeps for which a node is tracked, and number of reversals that count as chatter. */
    private static final int FOLLOWED = 16;

    private static final int TURNS = 14;
    private static final int FOLLOWED_RK4 = 32;
    private static final int TURNS_RK4 = 20;

    private final ParticleSystem system;
    private final double[] before;
    private final double[] last;
    private final int[] found;
    private final Workers.Task scan = this::scan;
    private final double[] pair = new double[6];
    private int substep;
    /** Internal number of the tracked node, substeps since tracking began, and reversals counted. */
    private int followed = NONE;

    private int since;
    private int turns;

    ChatterDetector(ParticleSystem system) {
        this.system = system;
        before = new double[system.velocities().length];
        last = new double[before.length];
        found = new int[system.layout().blockCount()];
    }

    /** Restarts detection after a change of step or state. */
    void reset() {
        substep = 0;
        followed = NONE;
    }

    /** Call after each substep of a scheme; returns the caller's number of a node that chatters, or -1. */
    int afterSubstep(IntegratorKind kind) {
        if (followed != NONE) {
            return kind == IntegratorKind.RK4 ? follow(FOLLOWED_RK4, TURNS_RK4) : follow(FOLLOWED, TURNS);
        }
        substep++;
        if (substep == PERIOD - 2) {
            System.arraycopy(system.velocities(), 0, before, 0, before.length);
        } else if (substep == PERIOD - 1) {
            System.arraycopy(system.velocities(), 0, last, 0, last.length);
        } else if (substep == PERIOD) {
            substep = 0;
            system.workers().run(found.length, scan);
            for (int block = 0; block < found.length && followed == NONE; block++) {
                followed = found[block];
            }
            if (followed != NONE) {
                since = 0;
                turns = 0;
                System.arraycopy(system.velocities(), 3 * followed, pair, 0, 3);
            }
        }
        return NONE;
    }

    private int follow(int substeps, int needed) {
        System.arraycopy(system.velocities(), 3 * followed, pair, 3, 3);
        turns += reversed(pair, 0, pair, 3) ? 1 : 0;
        System.arraycopy(pair, 3, pair, 0, 3);
        since++;
        if (turns + substeps - since < needed) {
            followed = NONE;
        } else if (since == substeps) {
            int node = system.layout().caller(followed);
            followed = NONE;
            return node;
        }
        return NONE;
    }

    private void scan(int block) {
        double[] v = system.velocities();
        int node = NONE;
        for (int n = system.layout().start(block); n < system.layout().end(block) && node == NONE; n++) {
            if (reversed(before, 3 * n, last, 3 * n) && reversed(last, 3 * n, v, 3 * n)) {
                node = n;
            }
        }
        found[block] = node;
    }

    private static boolean reversed(double[] u, int i, double[] v, int k) {
        double size = u[i] * u[i]
                + u[i + 1] * u[i + 1]
                + u[i + 2] * u[i + 2]
                + v[k] * v[k]
                + v[k + 1] * v[k + 1]
                + v[k + 2] * v[k + 2];
        double dx = v[k] - u[i];
        double dy = v[k + 1] - u[i + 1];
        double dz = v[k + 2] - u[i + 2];
        return size > 2 * SPEED * SPEED && dx * dx + dy * dy + dz * dz > TURN * size;
    }
}
