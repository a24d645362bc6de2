package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.Workers;

/**
 * Classical Runge-Kutta:
 *
 * <pre>
 * 0   |
 * 1/2 | 1/2
 * 1/2 | 0    1/2
 * 1   | 0    0    1
 * ----+--------------------
 *     | 1/6  1/3  1/3  1/6
 * </pre>
 *
 * <p>Order 4, four force evaluations a step, stable for ω h &lt; 2.83. Constraints are projected once, at the end of
 * the step.
 */
final class ClassicalRungeKutta extends Integrator {
    private static final double[] NODE = {0, 0.5, 0.5, 1};
    private static final double[] WEIGHT = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

    private final double[] x0;
    private final double[] v0;
    private final double[] sumX;
    private final double[] sumV;
    private final double[] acceleration;
    private double h;
    private int stage;
    private final Workers.Task advance = this::advance;

    ClassicalRungeKutta(ParticleSystem system) {
        super(IntegratorKind.RK4, system);
        x0 = new double[x.length];
        v0 = new double[x.length];
        sumX = new double[x.length];
        sumV = new double[x.length];
        acceleration = new double[x.length];
    }

    @Override
    public void step(double time, double step) {
        h = step;
        system.applyPrescribed(time, x, v);
        System.arraycopy(x, 0, x0, 0, x.length);
        System.arraycopy(v, 0, v0, 0, v.length);
        System.arraycopy(x, 0, sumX, 0, x.length);
        System.arraycopy(v, 0, sumV, 0, v.length);
        for (stage = 0; stage < 4; stage++) {
            double at = time + NODE[stage] * step;
            if (stage > 0) {
                system.applyPrescribed(at, x, v);
            }
            forces.at(at);
            system.workers().run(layout.blockCount(), advance);
        }
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
        system.projectVelocities();
    }

    private void advance(int block) {
        accelerations(force, v, acceleration, block);
        double weight = h * WEIGHT[stage];
        boolean last = stage == 3;
        double next = last ? 0 : h * NODE[stage + 1];
        for (int i = 3 * layout.start(block); i < 3 * layout.end(block); i++) {
            sumX[i] += weight * v[i];
            sumV[i] += weight * acceleration[i];
            double velocity = v[i];
            v[i] = last ? sumV[i] : v0[i] + next * acceleration[i];
            x[i] = last ? sumX[i] : x0[i] + next * velocity;
        }
    }

    static double[][] amplification(double a, double b) {
        double[][] z = generator(a, b);
        double[][] z2 = product(z, z);
        double[][] z3 = product(z2, z);
        double[][] low = linearCombination(1, linearCombination(1, identity(), 1, z), 0.5, z2);
        return linearCombination(1, low, 1, linearCombination(1.0 / 6, z3, 1.0 / 24, product(z3, z)));
    }
}
