package org.phrenic.engine.integrator;

import java.util.Arrays;
import org.phrenic.engine.ForceEvaluation;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * A scheme that advances a {@link ParticleSystem} by one time step. It owns its work arrays, so each system needs its
 * own integrator.
 */
public abstract class Integrator {
    final ParticleSystem system;
    final NodeLayout layout;
    final double[] x;
    final double[] v;
    final double[] inverseMass;
    final double[] viscosity;
    final double[] force;
    /** Writes to {@link #force}. */
    final ForceEvaluation forces;

    private final IntegratorKind kind;

    Integrator(IntegratorKind kind, ParticleSystem system) {
        this.kind = kind;
        this.system = system;
        layout = system.layout();
        x = system.positions();
        v = system.velocities();
        inverseMass = system.inverseMasses();
        viscosity = system.viscosities();
        force = new double[x.length];
        forces = kind == IntegratorKind.BACKWARD_EULER
                ? system.evaluation(x, v, force, null)
                : system.inertialEvaluation(x, v, force, null);
    }

    /** The kind of this scheme. */
    public final IntegratorKind kind() {
        return kind;
    }

    /** The system that is integrated. */
    public final ParticleSystem system() {
        return system;
    }

    /**
     * Advances the system from time to time + h, including constraints. Allocates nothing.
     *
     * @param time simulated time at the start, s
     * @param h step, s, more than 0
     */
    public abstract void step(double time, double h);

    /**
     * Discards cached values of earlier steps. Call it, and {@link ParticleSystem#invalidate}, after positions,
     * velocities or forces were changed from outside.
     */
    public void reset() {}

    /**
     * Sets the number of equal steps in which the {@link NodeLayout#hasNodesApart nodes apart} make each step of the
     * others. Only schemes of a kind that {@link IntegratorKind#stepsNodesApart steps nodes apart} take more than one.
     */
    public void setStepsApart(int steps) {
        if (steps != 1) {
            throw new IllegalArgumentException(kind.label() + ": found " + steps + " steps apart, expected 1");
        }
    }

    /** (f - γ v) / m for the nodes of one block; 0 where the motion is prescribed. */
    final void accelerations(double[] f, double[] velocity, double[] out, int block) {
        for (int n = layout.start(block); n < layout.end(block); n++) {
            double w = inverseMass[n];
            double g = viscosity[n];
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                out[i] = w * (f[i] - g * velocity[i]);
            }
        }
    }

    /** The sum of two square matrices times scalars, for the amplification matrices. */
    static double[][] linearCombination(double s, double[][] p, double t, double[][] q) {
        double[][] out = new double[p.length][p.length];
        for (int i = 0; i < p.length; i++) {
            for (int j = 0; j < p.length; j++) {
                out[i][j] = s * p[i][j] + t * q[i][j];
            }
        }
        return out;
    }

    static double[][] product(double[][] p, double[][] q) {
        double[][] out = new double[p.length][p.length];
        for (int i = 0; i < p.length; i++) {
            Arrays.fill(out[i], 0);
            for (int j = 0; j < p.length; j++) {
                for (int k = 0; k < p.length; k++) {
                    out[i][j] += p[i][k] * q[k][j];
                }
            }
        }
        return out;
    }

    /** h A of the oscillator in the variables (x, v h): the exact flow is its exponential. */
    static double[][] generator(double a, double b) {
        return new double[][] {{0, 1}, {-a, -b}};
    }

    static double[][] identity() {
        return new double[][] {{1, 0}, {0, 1}};
    }
}
