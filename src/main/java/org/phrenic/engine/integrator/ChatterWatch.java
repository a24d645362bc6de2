package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.Workers;

/**
 * Notices what the stability limit, measured on the scene as it was, cannot foresee: that links under load, pressure or great stretch have made the scene stiffer than the step bears. A scheme
 * beyond its limit then swings from one substep to the next at the highest frequency, for RK4 by 110 degrees or more and for the others by 180, while all motion of a body is smooth over many steps. A node chatters
 * if its velocity turns round by more than 100 degrees or so in each of two successive substeps, at more than 20 mm/s.
 *
 * <p>Looked for in every sixteenth substep only, so that it costs a few copies of the velocities in that time.
 */
final class ChatterWatch {
    private static final int PERIOD = 16;
    /** |u - v|² over |u|² + |v|²: 0 for the same velocity, 1 for one at a right angle or none, 2 for the opposite. */
    private static final double TURN = 1.2;
    /** As fast as the dome in quiet breathing, mm/s. */
    private static final double SPEED = 20;

    private static final int NONE = -1;

    private final ParticleSystem system;
    private final double[] before;
    private final double[] last;
    private final int[] found;
    private final Workers.Task scan = this::scan;
    private int substep;

    ChatterWatch(ParticleSystem system) {
        this.system = system;
        before = new double[system.velocities().length];
        last = new double[before.length];
        found = new int[system.layout().blockCount()];
    }

    /** Begins anew: what was seen so far belongs to another step or state. */
    void reset() {
        substep = 0;
    }

    /** Told after each substep; the caller's number of a node that chatters, or -1. */
    int after() {
        substep++;
        if (substep == PERIOD - 2) {
            System.arraycopy(system.velocities(), 0, before, 0, before.length);
        } else if (substep == PERIOD - 1) {
            System.arraycopy(system.velocities(), 0, last, 0, last.length);
        } else if (substep == PERIOD) {
            substep = 0;
            system.workers().run(found.length, scan);
            for (int node : found) {
                if (node != NONE) {
                    return system.layout().caller(node);
                }
            }
        }
        return NONE;
    }

    private void scan(int block) {
        double[] v = system.velocities();
        int node = NONE;
        for (int n = system.layout().start(block); n < system.layout().end(block) && node == NONE; n++) {
            if (turned(before, last, 3 * n) && turned(last, v, 3 * n)) {
                node = n;
            }
        }
        found[block] = node;
    }

    private static boolean turned(double[] u, double[] v, int i) {
        double size = u[i] * u[i]
                + u[i + 1] * u[i + 1]
                + u[i + 2] * u[i + 2]
                + v[i] * v[i]
                + v[i + 1] * v[i + 1]
                + v[i + 2] * v[i + 2];
        double dx = v[i] - u[i];
        double dy = v[i + 1] - u[i + 1];
        double dz = v[i + 2] - u[i + 2];
        return size > 2 * SPEED * SPEED && dx * dx + dy * dy + dz * dz > TURN * size;
    }
}
