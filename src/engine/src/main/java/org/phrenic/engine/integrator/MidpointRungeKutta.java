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
 *
 * <p>Nodes apart make each step in several shorter ones, before the others do. As no force acts between the two, each
 * part goes as if it were alone, at the order of the scheme.
 */
final class MidpointRungeKutta extends Integrator {
    private final double[] x0;
    private final double[] v0;
    private final double[] acceleration;
    private double h;
    private int stepsApart = 1;
    private int firstBlock;
    private final Workers.Task toMiddle = piece -> toMiddle(firstBlock + piece);
    private final Workers.Task toEnd = piece -> toEnd(firstBlock + piece);

    MidpointRungeKutta(ParticleSystem system) {
        super(IntegratorKind.RK2, system);
        x0 = new double[x.length];
        v0 = new double[x.length];
        acceleration = new double[x.length];
    }

    @Override
    public void step(double time, double step) {
        int blocks = layout.blockCount();
        int apart = stepsApart == 1 ? blocks : layout.firstBlockApart();
        for (int i = 0; apart < blocks && i < stepsApart; i++) {
            h = step / stepsApart;
            firstBlock = apart;
            advance(time + i * h, blocks, false);
        }
        h = step;
        firstBlock = 0;
        advance(time, apart, true);
        system.project(time + step, step);
        system.projectVelocities();
    }

    /** Advances blocks from {@code firstBlock} to {@code end - 1} by h. */
    private void advance(double time, int end, boolean prescribed) {
        int from = 3 * layout.start(firstBlock);
        int count = 3 * layout.end(end - 1) - from;
        if (prescribed) {
            system.applyPrescribed(time, x, v);
        }
        System.arraycopy(x, from, x0, from, count);
        System.arraycopy(v, from, v0, from, count);
        forces.at(time, firstBlock, end);
        system.workers().run(end - firstBlock, toMiddle);
        if (prescribed) {
            system.applyPrescribed(time + 0.5 * h, x, v);
        }
        forces.at(time + 0.5 * h, firstBlock, end);
        system.workers().run(end - firstBlock, toEnd);
        if (prescribed) {
            system.applyPrescribed(time + h, x, v);
        }
    }

    @Override
    public void setStepsApart(int steps) {
        stepsApart = steps;
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
