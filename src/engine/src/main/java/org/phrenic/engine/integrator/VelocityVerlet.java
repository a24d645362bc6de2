package org.phrenic.engine.integrator;

import org.phrenic.engine.ForceEvaluation;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Velocity Verlet with semi-implicit viscous damping, the default scheme. With w = γ h / 2m:
 *
 * <pre>
 * v(t+h/2) = (v(t) + h/2 f(t)/m) / (1 + w)
 * x(t+h)   = x(t) + h v(t+h/2)              then constraints; v(t+h/2) gets their shift / h
 * v(t+h)   = (1 - w) v(t+h/2) + h/2 f(t+h)/m   then constraints of velocity
 * </pre>
 *
 * <p>Between half steps this is v' = ((1-w) v + h f/m) / (1+w). Order 2, one force evaluation a step, symplectic
 * without damping, stable for ω h &lt; 2 at any viscosity. Dashpots along springs use the velocity at the half step, so
 * their contribution is of order 1.
 */
final class VelocityVerlet extends Integrator {
    private boolean forceIsCurrent;
    private double h;
    private final Workers.Task kickAndDrift = this::kickAndDrift;
    private final Workers.Task kick = this::kick;
    private final ForceEvaluation forcesAndKick = system.inertialEvaluation(x, v, force, kick);

    VelocityVerlet(ParticleSystem system) {
        super(IntegratorKind.VERLET, system);
    }

    @Override
    public void reset() {
        forceIsCurrent = false;
    }

    @Override
    public void step(double time, double step) {
        h = step;
        if (!forceIsCurrent) {
            system.applyPrescribed(time, x, v);
            forces.at(time);
        }
        int blocks = layout.blockCount();
        system.workers().run(blocks, kickAndDrift);
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
        if (system.dependsOnVelocity()) {
            forces.at(time + step);
            system.workers().run(blocks, kick);
        } else {
            forcesAndKick.at(time + step);
        }
        system.projectVelocities();
        forceIsCurrent = true;
    }

    private void kickAndDrift(int block) {
        int end = layout.end(block);
        for (int from = layout.start(block); from < end; from += NodeLayout.LOOP_CHUNK) {
            kickAndDrift(from, Math.min(end, from + NodeLayout.LOOP_CHUNK));
        }
    }

    private void kickAndDrift(int from, int end) {
        double[] f = force;
        double[] position = x;
        double[] velocity = v;
        double[] w = inverseMass;
        double[] gamma = viscosity;
        double step = h;
        for (int n = from; n < end; n++) {
            double half = 0.5 * step * w[n];
            double damp = 1 / (1 + half * gamma[n]);
            int i = 3 * n;
            double vx = (velocity[i] + half * f[i]) * damp;
            double vy = (velocity[i + 1] + half * f[i + 1]) * damp;
            double vz = (velocity[i + 2] + half * f[i + 2]) * damp;
            velocity[i] = vx;
            velocity[i + 1] = vy;
            velocity[i + 2] = vz;
            // This also moves prescribed nodes; they are set to their positions afterwards.
            position[i] += step * vx;
            position[i + 1] += step * vy;
            position[i + 2] += step * vz;
        }
    }

    /** Updates velocities. Prescribed nodes are unaffected, because their inverse mass is 0. */
    private void kick(int block) {
        int end = layout.end(block);
        for (int from = layout.start(block); from < end; from += NodeLayout.LOOP_CHUNK) {
            kick(from, Math.min(end, from + NodeLayout.LOOP_CHUNK));
        }
    }

    private void kick(int from, int end) {
        double[] f = force;
        double[] velocity = v;
        double[] w = inverseMass;
        double[] gamma = viscosity;
        double step = h;
        for (int n = from; n < end; n++) {
            double half = 0.5 * step * w[n];
            double damp = 1 - half * gamma[n];
            int i = 3 * n;
            velocity[i] = damp * velocity[i] + half * f[i];
            velocity[i + 1] = damp * velocity[i + 1] + half * f[i + 1];
            velocity[i + 2] = damp * velocity[i + 2] + half * f[i + 2];
        }
    }

    static double[][] amplification(double a, double b) {
        double w = b / 2;
        double damp = 1 / (1 + w);
        // u = v(t+h/2) h as a row over (x, v h), then x' = x + u, v' h = (1 - w) u - a x' / 2.
        double ux = -0.5 * a * damp;
        double uv = damp;
        return new double[][] {{1 + ux, uv}, {(1 - w) * ux - 0.5 * a * (1 + ux), (1 - w) * uv - 0.5 * a * uv}};
    }

    static double[][] amplification(double a, double b, double c) {
        double w = b / 2;
        double damp = 1 / (1 + w);
        // State (x, v h, f h²/m) with the cached force of the last step; u = (v h + f/2) damp, x' = x + u, f' = -a x'
        // - c u, v' h = (1 - w) u + f'/2.
        double f = -(a + c) * damp;
        return new double[][] {
            {1, damp, 0.5 * damp},
            {-0.5 * a, (1 - w) * damp + 0.5 * f, 0.5 * ((1 - w) * damp + 0.5 * f)},
            {-a, f, 0.5 * f}
        };
    }
}
