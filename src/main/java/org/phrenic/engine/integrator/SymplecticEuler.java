package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.Workers;

/**
 * Symplectic (semi-implicit) Euler: v += h a(x, v), then x += h v with the new velocity. Order 1, one force evaluation a step; undamped it is stable for ω h &lt; 2.
 */
final class SymplecticEuler extends AbstractIntegrator {
    private double h;
    private final Workers.Task advance = this::advance;

    SymplecticEuler(ParticleSystem system) {
        super(IntegratorKind.SYMPLECTIC_EULER, system);
    }

    @Override
    public void step(double time, double step) {
        h = step;
        system.applyPrescribed(time, x, v);
        system.forces(time, x, v, force);
        system.workers().run(layout.blockCount(), advance);
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
    }

    private void advance(int block) {
        for (int n = layout.start(block); n < layout.end(block); n++) {
            double m = inverseMass[n];
            if (m == 0) {
                continue;
            }
            double g = viscosity[n];
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                v[i] += h * m * (force[i] - g * v[i]);
                x[i] += h * v[i];
            }
        }
    }

    static double[][] amplification(double a, double b) {
        return new double[][] {{1 - a, 1 - b}, {-a, 1 - b}};
    }
}
