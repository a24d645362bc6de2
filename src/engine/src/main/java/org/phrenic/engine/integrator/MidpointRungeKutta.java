package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.Workers;

/**
 * Midpoint Runge-Kutta (the second-order Runge-Kutta that Villard, Bourne and Bello 2009 name):
 *
 * <pre>
 * 0   |
 * 1/2 | 1/2
 * ----+---------
 *     | 0    1
 * </pre>
 *
 * <p>Order 2, two force evaluations a step. On the imaginary axis |R(iy)|² = 1 + y⁴/4, so without damping it grows at
 * every step size. With viscosity it is stable only while ω⁴ h³ / 8 &lt; γ / 2m. The paper's parameters k = 15, m =
 * 0.1, γ = 0.02, h = 0.01 are outside this range.
 */
final class MidpointRungeKutta extends AbstractIntegrator {
    private final double[] x0;
    private final double[] v0;
    private final double[] acceleration;
    private double h;
    private final Workers.Task toMiddle = this::toMiddle;
    private final Workers.Task toEnd = this::toEnd;

    MidpointRungeKutta(ParticleSystem system) {
        super(IntegratorKind.RK2, system);
        x0 = new double[x.length];
        v0 = new double[x.length];
        acceleration = new double[x.length];
    }

    @Override
    public void step(double time, double step) {
        h = step;
        int blocks = layout.blockCount();
        system.applyPrescribed(time, x, v);
        System.arraycopy(x, 0, x0, 0, x.length);
        System.arraycopy(v, 0, v0, 0, v.length);
        forces.at(time);
        system.workers().run(blocks, toMiddle);
        system.applyPrescribed(time + 0.5 * step, x, v);
        forces.at(time + 0.5 * step);
        system.workers().run(blocks, toEnd);
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
        system.projectVelocities();
    }

    private void toMiddle(int block) {
        accelerations(force, v0, acceleration, block);
        for (int i = 3 * layout.start(block); i < 3 * layout.end(block); i++) {
            x[i] = x0[i] + 0.5 * h * v0[i];
            v[i] = v0[i] + 0.5 * h * acceleration[i];
        }
    }

    private void toEnd(int block) {
        accelerations(force, v, acceleration, block);
        for (int i = 3 * layout.start(block); i < 3 * layout.end(block); i++) {
            x[i] = x0[i] + h * v[i];
            v[i] = v0[i] + h * acceleration[i];
        }
    }

    static double[][] amplification(double a, double b) {
        double[][] z = generator(a, b);
        return linearCombination(1, linearCombination(1, identity(), 1, z), 0.5, product(z, z));
    }
}
