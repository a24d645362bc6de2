package org.phrenic.engine.integrator;

import org.phrenic.engine.ForceEvaluation;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.Workers;

/**
 * Symplectic (semi-implicit) Euler: v += h a(x, v), then x += h v with the new velocity. Order 1, one force evaluation
 * a step; without damping stable for ω h &lt; 2.
 */
final class SymplecticEuler extends Integrator {
    private double h;
    private final Workers.Task kick = this::kick;
    private final ForceEvaluation forcesAndKick = system.inertialEvaluation(x, v, force, kick);
    private final Workers.Task drift = this::drift;

    SymplecticEuler(ParticleSystem system) {
        super(IntegratorKind.SYMPLECTIC_EULER, system);
    }

    @Override
    public void step(double time, double step) {
        h = step;
        system.applyPrescribed(time, x, v);
        forcesAndKick.at(time);
        system.workers().run(layout.blockCount(), drift);
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
    }

    /** Overwrites forces with new velocities; the old velocities are still needed by other blocks. */
    private void kick(int block) {
        double[] f = force;
        double[] old = v;
        double[] w = inverseMass;
        double[] gamma = viscosity;
        double step = h;
        int end = layout.end(block);
        for (int n = layout.start(block); n < end; n++) {
            double m = step * w[n];
            double g = gamma[n];
            int i = 3 * n;
            double vx = old[i];
            double vy = old[i + 1];
            double vz = old[i + 2];
            f[i] = vx + m * (f[i] - g * vx);
            f[i + 1] = vy + m * (f[i + 1] - g * vy);
            f[i + 2] = vz + m * (f[i + 2] - g * vz);
        }
    }

    /** Updates positions. This also moves prescribed nodes; they are set to their positions afterwards. */
    private void drift(int block) {
        double[] next = force;
        double[] position = x;
        double[] velocity = v;
        double step = h;
        int from = 3 * layout.start(block);
        int end = 3 * layout.end(block);
        System.arraycopy(next, from, velocity, from, end - from);
        for (int i = from; i < end; i++) {
            position[i] += step * next[i];
        }
    }

    static double[][] amplification(double a, double b) {
        return new double[][] {{1 - a, 1 - b}, {-a, 1 - b}};
    }
}
