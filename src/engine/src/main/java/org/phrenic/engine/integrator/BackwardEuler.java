package org.phrenic.engine.integrator;

import java.util.Arrays;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.Workers;

/**
 * Backward Euler for stiff scenes, linearised once a step (Baraff and Witkin 1998, doi 10.1145/280814.280821):
 *
 * <pre>
 * (M + h Γ + h² K) v' = M v + h f(x)      from f(x + h v') ≈ f(x) - h K v'
 * x' = x + h v'
 * </pre>
 *
 * <p>Solved by conjugate gradients with a diagonal preconditioner, without a matrix (fields give K u), starting from
 * the velocity at hand. Order 1, stable for every h; it damps what it does not resolve. Fields that give no K
 * (pressure, dead loads) and dashpots along springs enter explicitly.
 */
final class BackwardEuler extends AbstractIntegrator {
    /** Residual left over, as a share of the right-hand side: well below the scheme's own error at any usable step. */
    private static final double TOLERANCE = 1e-8;

    private static final int MAX_ITERATIONS = 500;

    private final double[] right;
    private final double[] residual;
    private final double[] direction;
    private final double[] image;
    private final double[] diagonal;
    private final double[] stiffnessSum;
    private final double[] dampingSum;
    private final double[] partial;
    private double h;
    private double[] operand;
    private final Workers.Task apply = this::apply;
    private final Workers.Task dotTask = this::dotBlock;
    private double[] dotP;
    private double[] dotQ;
    private boolean dotWeighted;
    private int lastIterationCount;

    BackwardEuler(ParticleSystem system) {
        super(IntegratorKind.BACKWARD_EULER, system);
        right = new double[x.length];
        residual = new double[x.length];
        direction = new double[x.length];
        image = new double[x.length];
        diagonal = new double[system.nodeCount()];
        stiffnessSum = new double[system.nodeCount()];
        dampingSum = new double[system.nodeCount()];
        partial = new double[layout.blockCount()];
    }

    /** Conjugate-gradient iterations of the last step. */
    int lastIterationCount() {
        return lastIterationCount;
    }

    @Override
    public void step(double time, double step) {
        h = step;
        system.applyPrescribed(time, x, v);
        system.forces(time + step, x, v, force);
        Arrays.fill(stiffnessSum, 0);
        Arrays.fill(dampingSum, 0);
        system.addRowSums(stiffnessSum, dampingSum);
        double[] mass = system.masses();
        for (int n = 0; n < diagonal.length; n++) {
            // Half a row sum is the diagonal of a graph Laplacian.
            diagonal[n] = 1 / (mass[n] + h * viscosity[n] + 0.5 * h * h * stiffnessSum[n]);
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                right[i] = inverseMass[n] == 0 ? 0 : mass[n] * v[i] + h * force[i];
            }
        }
        solve();
        for (int i = 0; i < x.length; i++) {
            if (inverseMass[i / 3] != 0) {
                x[i] += h * v[i];
            }
        }
        system.applyPrescribed(time + step, x, v);
        system.project(time + step, step);
    }

    /** Conjugate gradients on the free nodes, starting from v; nodes of given motion keep their v. */
    private void solve() {
        multiply(v);
        for (int i = 0; i < x.length; i++) {
            residual[i] = inverseMass[i / 3] == 0 ? 0 : right[i] - image[i];
            direction[i] = residual[i] * diagonal[i / 3];
        }
        double goal = TOLERANCE * TOLERANCE * dot(right, right, true);
        double rho = dot(residual, residual, true);
        lastIterationCount = 0;
        if (!Double.isFinite(rho)) {
            // A force that is no number must show in the velocity of its node, not be passed over.
            for (int i = 0; i < x.length; i++) {
                v[i] += residual[i];
            }
            return;
        }
        while (lastIterationCount < MAX_ITERATIONS && rho > goal) {
            multiply(direction);
            double alpha = rho / dot(direction, image, false);
            for (int i = 0; i < x.length; i++) {
                v[i] += alpha * direction[i];
                residual[i] -= alpha * image[i];
            }
            double next = dot(residual, residual, true);
            double beta = next / rho;
            rho = next;
            for (int i = 0; i < x.length; i++) {
                direction[i] = residual[i] * diagonal[i / 3] + beta * direction[i];
            }
            lastIterationCount++;
        }
    }

    private void multiply(double[] u) {
        operand = u;
        system.workers().run(layout.blockCount(), apply);
    }

    private void apply(int block) {
        double[] mass = system.masses();
        Arrays.fill(image, 3 * layout.start(block), 3 * layout.end(block), 0);
        system.addStiffness(x, operand, image, block);
        for (int n = layout.start(block); n < layout.end(block); n++) {
            double own = mass[n] + h * viscosity[n];
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                image[i] = inverseMass[n] == 0 ? 0 : own * operand[i] + h * h * image[i];
            }
        }
    }

    /**
     * Dot product summed block by block, so that it is the same for any number of threads; optionally in the
     * preconditioner's measure.
     */
    private double dot(double[] p, double[] q, boolean preconditioned) {
        dotP = p;
        dotQ = q;
        dotWeighted = preconditioned;
        system.workers().run(partial.length, dotTask);
        double sum = 0;
        for (double part : partial) {
            sum += part;
        }
        return sum;
    }

    private void dotBlock(int block) {
        double sum = 0;
        for (int n = layout.start(block); n < layout.end(block); n++) {
            double weight = dotWeighted ? diagonal[n] : 1;
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                sum += weight * dotP[i] * dotQ[i];
            }
        }
        partial[block] = sum;
    }

    static double[][] amplification(double a, double b) {
        return amplification(a, b, 0);
    }

    static double[][] amplification(double a, double b, double c) {
        double inverse = 1 / (1 + b + a);
        // v' h = ((1 - c) v h - a x) / (1 + b + a), x' = x + v' h.
        return new double[][] {{1 - a * inverse, (1 - c) * inverse}, {-a * inverse, (1 - c) * inverse}};
    }
}
