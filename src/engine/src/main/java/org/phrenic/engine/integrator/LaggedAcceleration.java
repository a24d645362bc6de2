package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.Workers;

/**
 * Eq. 6 of Villard, Bourne and Bello 2009, read literally:
 *
 * <pre>
 * v(t+h/2) = v(t) + h/2 a(t-h)
 * a(t)     = Σ f(x(t), v(t+h/2)) / m
 * v(t+h)   = v(t+h/2) + h/2 a(t)
 * x(t+h)   = x(t) + h v(t) + h²/2 a(t-h)
 * </pre>
 *
 * <p>The acceleration lags one step, so the scheme is of order 1 and adds energy (without damping the amplitude grows
 * like exp(h ω² t / 2)). Stability requires viscosity γ/m &gt; h ω². The first step uses a(t-h) = a(t).
 */
final class LaggedAcceleration extends Integrator {
    private final double[] lagged;
    private boolean hasLagged;
    private double h;
    private final Workers.Task start = this::start;
    private final Workers.Task halfKick = this::halfKick;
    private final Workers.Task advance = this::advance;

    LaggedAcceleration(ParticleSystem system) {
        super(IntegratorKind.LAGGED, system);
        lagged = new double[x.length];
    }

    @Override
    public void reset() {
        hasLagged = false;
    }

    @Override
    public void step(double time, double step) {
        h = step;
        int blocks = layout.blockCount();
        system.applyPrescribed(time, x, v);
        if (!hasLagged) {
            forces.at(time);
            system.workers().run(blocks, start);
            hasLagged = true;
        }
        system.workers().run(blocks, halfKick);
        forces.at(time);
        system.workers().run(blocks, advance);
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
        system.projectVelocities();
    }

    private void start(int block) {
        accelerations(force, v, lagged, block);
    }

    private void halfKick(int block) {
        for (int n = layout.start(block); n < layout.end(block); n++) {
            if (inverseMass[n] != 0) {
                for (int i = 3 * n; i < 3 * n + 3; i++) {
                    v[i] += 0.5 * h * lagged[i];
                }
            }
        }
    }

    private void advance(int block) {
        for (int n = layout.start(block); n < layout.end(block); n++) {
            double m = inverseMass[n];
            if (m == 0) {
                continue;
            }
            double g = viscosity[n];
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                // x(t) + h v(t) + h²/2 a(t-h) = x(t) + h v(t+h/2).
                x[i] += h * v[i];
                double now = m * (force[i] - g * v[i]);
                v[i] += 0.5 * h * now;
                lagged[i] = now;
            }
        }
    }

    static double[][] amplification(double a, double b) {
        // State (x, v h, a(t-h) h²); u = v h + lag/2, now = -a x - b u, x' = x + u, v' h = u + now/2.
        return new double[][] {
            {1, 1, 0.5},
            {-0.5 * a, 1 - 0.5 * b, 0.5 * (1 - 0.5 * b)},
            {-a, -b, -0.5 * b}
        };
    }
}
