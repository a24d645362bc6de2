package org.phrenic.engine.integrator;

import java.util.Arrays;
import org.phrenic.engine.ForceEvaluation;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.Workers;

/**
 * Störmer's explicit formula with second differences, in velocity form: order 3 with one force evaluation a step. Let u
 * be the displacement of a step divided by h, a = (f - γ v) / m, and ∇ the backward difference between steps:
 *
 * <pre>
 * u      = v(t) + h (1/2 a + 1/6 ∇a + 1/8 ∇²a)(t)
 * x(t+h) = x(t) + h u                                         then constraints; u gets their shift / h
 * v(t+h) = u + h (1/2 a - 1/6 ∇a - 1/24 ∇²a)(t+h)             then constraints of velocity
 * </pre>
 *
 * <p>From one step to the next, u' = u + h (a + ∇²a / 12), which is Störmer's formula. Without the differences it is
 * velocity Verlet. The leading error is damping, h³ ω⁴ / 12, so frequencies far below the stability limit are more
 * accurate. Viscosity is implicit in the last line and explicit in the first. Dashpots along springs use a velocity
 * extrapolated from the three known accelerations. The first two steps after {@link #reset()} omit the differences that
 * are not yet known. The order holds only for motion that is smooth on the scale of a step: at a jump of the force
 * (contact, a limit) the accuracy is that of Verlet.
 *
 * <p>Source: C. Störmer, Sur les trajectoires des corpuscules électrisés, 1907; E. Hairer, S. P. Nørsett and G. Wanner,
 * Solving Ordinary Differential Equations I, 2nd edition 1993, section III.10.
 */
final class Stormer extends Integrator {
    /** Coefficients of a(t), a(t-h), a(t-2h) in (u - v(t)) / h. Row i is for i + 1 known accelerations. */
    private static final double[][] LEAVING = {{1 / 2.0, 0, 0}, {2 / 3.0, -1 / 6.0, 0}, {19 / 24.0, -5 / 12.0, 1 / 8.0}
    };

    /** Coefficients of a(t+h), a(t), a(t-h) in (v(t+h) - u) / h, as above. */
    private static final double[][] ARRIVING = {{1 / 2.0, 0, 0}, {1 / 3.0, 1 / 6.0, 0}, {7 / 24.0, 1 / 4.0, -1 / 24.0}};

    /** Extrapolation coefficients of a(t+h) from a(t), a(t-h), a(t-2h), as above. */
    private static final double[][] AHEAD = {{1, 0, 0}, {2, -1, 0}, {3, -3, 1}};

    private final double[][] history = new double[3][];
    private int known;
    private double h;
    private final Workers.Task start = this::start;
    private final Workers.Task kickAndDrift = this::kickAndDrift;
    private final Workers.Task predictVelocity = this::predictVelocity;
    private final Workers.Task kick = this::kick;
    private final ForceEvaluation forcesAndKick = system.inertialEvaluation(x, v, force, kick);
    private final Workers.Task correctAndKick = this::correctAndKick;

    Stormer(ParticleSystem system) {
        super(IntegratorKind.STORMER, system);
        Arrays.setAll(history, i -> new double[x.length]);
    }

    @Override
    public void reset() {
        if (known > 0) {
            // Unknown accelerations are multiplied by 0, which a NaN of a failed step would survive.
            for (double[] accelerations : history) {
                Arrays.fill(accelerations, 0);
            }
        }
        known = 0;
    }

    @Override
    public void step(double time, double step) {
        int blocks = layout.blockCount();
        if (known == 0 || step != h) {
            system.applyPrescribed(time, x, v);
            forces.at(time);
            system.workers().run(blocks, start);
            known = 1;
        }
        h = step;
        system.workers().run(blocks, kickAndDrift);
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
        if (system.dependsOnVelocity()) {
            system.workers().run(blocks, predictVelocity);
            forces.at(time + step);
            system.workers().run(blocks, correctAndKick);
        } else {
            forcesAndKick.at(time + step);
        }
        system.projectVelocities();
        double[] oldest = history[2];
        history[2] = history[1];
        history[1] = history[0];
        history[0] = oldest;
        known = Math.min(known + 1, history.length);
    }

    /** The acceleration at t-ih, i = 0, 1, 2, if known. */
    double[] acceleration(int i) {
        return history[i];
    }

    private void start(int block) {
        accelerations(force, v, history[0], block);
    }

    private void kickAndDrift(int block) {
        double[] c = LEAVING[known - 1];
        double c0 = h * c[0];
        double c1 = h * c[1];
        double c2 = h * c[2];
        double[] a0 = history[0];
        double[] a1 = history[1];
        double[] a2 = history[2];
        double[] position = x;
        double[] velocity = v;
        double step = h;
        int end = 3 * layout.end(block);
        // This also moves prescribed nodes; they are set to their positions afterwards.
        for (int i = 3 * layout.start(block); i < end; i++) {
            double u = velocity[i] + (c0 * a0[i] + c1 * a1[i] + c2 * a2[i]);
            velocity[i] = u;
            position[i] += step * u;
        }
    }

    /** Predicts v(t+h) from u and the extrapolated acceleration, for forces that depend on velocity. */
    private void predictVelocity(int block) {
        shift(block, h);
    }

    private void shift(int block, double step) {
        double[] c = ARRIVING[known - 1];
        double[] ahead = AHEAD[known - 1];
        double c0 = step * (c[0] * ahead[0] + c[1]);
        double c1 = step * (c[0] * ahead[1] + c[2]);
        double c2 = step * c[0] * ahead[2];
        double[] a0 = history[0];
        double[] a1 = history[1];
        double[] a2 = history[2];
        double[] velocity = v;
        int end = 3 * layout.end(block);
        for (int i = 3 * layout.start(block); i < end; i++) {
            velocity[i] += c0 * a0[i] + c1 * a1[i] + c2 * a2[i];
        }
    }

    private void correctAndKick(int block) {
        shift(block, -h);
        kick(block);
    }

    /**
     * Updates the velocity with implicit viscosity. The newest acceleration overwrites the oldest. Both are 0 for
     * prescribed nodes.
     */
    private void kick(int block) {
        double[] c = ARRIVING[known - 1];
        double c0 = h * c[0];
        double c1 = h * c[1];
        double c2 = h * c[2];
        double[] f = force;
        double[] a0 = history[0];
        double[] a1 = history[1];
        double[] newest = history[2];
        double[] velocity = v;
        double[] w = inverseMass;
        double[] gamma = viscosity;
        int end = layout.end(block);
        for (int n = layout.start(block); n < end; n++) {
            double m = w[n];
            double g = m * gamma[n];
            double damp = 1 / (1 + c0 * g);
            double d0 = c0 * damp;
            double d1 = c1 * damp;
            double d2 = c2 * damp;
            int i = 3 * n;
            double ax = m * f[i];
            double ay = m * f[i + 1];
            double az = m * f[i + 2];
            double vx = damp * velocity[i] + (d0 * ax + d1 * a0[i] + d2 * a1[i]);
            double vy = damp * velocity[i + 1] + (d0 * ay + d1 * a0[i + 1] + d2 * a1[i + 1]);
            double vz = damp * velocity[i + 2] + (d0 * az + d1 * a0[i + 2] + d2 * a1[i + 2]);
            velocity[i] = vx;
            velocity[i + 1] = vy;
            velocity[i + 2] = vz;
            newest[i] = ax - g * vx;
            newest[i + 1] = ay - g * vy;
            newest[i + 2] = az - g * vz;
        }
    }

    static double[][] amplification(double a, double b, double c) {
        double[] leaving = LEAVING[2];
        double[] arriving = ARRIVING[2];
        double[] ahead = AHEAD[2];
        double damp = 1 / (1 + arriving[0] * b);
        // State (x, v h, and h² times the accelerations at t, t-h, t-2h). u is a row over this state, then x' = x +
        // u, the predicted velocity, f' = -a x' - c times that velocity, v', and the newest acceleration f' - b v'.
        double[] u = {0, 1, leaving[0], leaving[1], leaving[2]};
        double[] foreseen = u.clone();
        for (int i = 0; i < 3; i++) {
            foreseen[2 + i] += arriving[0] * ahead[i] + (i < 2 ? arriving[i + 1] : 0);
        }
        double[][] out = new double[5][5];
        for (int j = 0; j < 5; j++) {
            double x = (j == 0 ? 1 : 0) + u[j];
            double f = -a * x - c * foreseen[j];
            double kept = j == 2 ? arriving[1] : j == 3 ? arriving[2] : 0;
            out[0][j] = x;
            out[1][j] = (u[j] + arriving[0] * f + kept) * damp;
            out[2][j] = f - b * out[1][j];
        }
        out[3][2] = 1;
        out[4][3] = 1;
        return out;
    }
}
