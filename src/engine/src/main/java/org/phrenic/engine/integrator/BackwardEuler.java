package org.phrenic.engine.integrator;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SelectiveMass;
import org.phrenic.engine.math.ConjugateGradient;
import org.phrenic.engine.math.DenseVectors;
import org.phrenic.engine.parallel.Workers;

/**
 * Backward Euler for stiff scenes, linearised once a step (Baraff and Witkin 1998, doi 10.1145/280814.280821):
 *
 * <pre>
 * (M + h Γ + h² K) v' = M v + h f(x)      from f(x + h v') ≈ f(x) - h K v'
 * x' = x + h v'
 * </pre>
 *
 * <p>The linear system is solved matrix-free (fields give K u) by conjugate gradients with a diagonal preconditioner,
 * starting from the current velocity. Order 1, stable for every h; frequencies that the step does not resolve are
 * damped. M is that of {@link SelectiveMass} where the system has one. Fields without K (pressure, dead loads) and
 * dashpots along springs are treated explicitly.
 */
final class BackwardEuler extends Integrator {
    /** Relative residual of the linear solve, well below the scheme's own error at any usable step. */
    private static final double TOLERANCE = 1e-8;

    /** Least bound of the number of iterations of a linear solve. */
    private static final int MIN_BOUND = 500;
    /**
     * Bound of the number of iterations of a linear solve, a node: in exact arithmetic one an unknown is enough, which
     * rounding makes more.
     */
    private static final int ITERATIONS_A_NODE = 10;

    private final double[] right;
    private final double[] residual;
    private final double[] image;
    private final double[] diagonal;
    private final double[] stiffnessSum;
    private final double[] dampingSum;
    private final VelocitySolver solver;
    private final int maxIterations;
    private double h;

    BackwardEuler(ParticleSystem system) {
        super(IntegratorKind.BACKWARD_EULER, system);
        right = new double[x.length];
        residual = new double[x.length];
        image = new double[x.length];
        diagonal = new double[system.nodeCount()];
        stiffnessSum = new double[system.nodeCount()];
        dampingSum = new double[system.nodeCount()];
        solver = new VelocitySolver();
        maxIterations =
                (int) Math.min(Integer.MAX_VALUE, Math.max(MIN_BOUND, (long) ITERATIONS_A_NODE * diagonal.length));
    }

    /** Conjugate-gradient iterations of the last step. */
    int lastIterationCount() {
        return solver.iterations();
    }

    @Override
    public void step(double time, double step) {
        h = step;
        system.applyPrescribed(time, x, v);
        forces.at(time + step);
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
        Optional<SelectiveMass> group = system.selectiveMass();
        if (group.isPresent()) {
            group.get().addInertia(1, v, right);
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

    /** Solves for the velocities of the free nodes, starting from v; prescribed nodes keep their v. */
    private void solve() {
        solver.multiply(v, image);
        for (int i = 0; i < x.length; i++) {
            residual[i] = inverseMass[i / 3] == 0 ? 0 : right[i] - image[i];
        }
        solver.precondition(right, image);
        double goal = TOLERANCE * TOLERANCE * solver.dot(right, image);
        // Forces or stiffness that are not finite, or a solve without an end, make the velocities NaN, which the
        // divergence guard detects.
        if (!Double.isFinite(solver.start(residual))) {
            DenseVectors.addScaled(v, 1, residual);
        } else if (!solver.solve(v, residual, goal, maxIterations) || solver.isExhausted()) {
            Arrays.fill(v, Double.NaN);
        }
    }

    /**
     * The operator M + h Γ + h² K on the free nodes with its diagonal as preconditioner. Sums are formed block by
     * block.
     */
    private final class VelocitySolver extends ConjugateGradient {
        private final double[] partial = new double[layout.blockCount()];
        private final Workers.Task multiplyTask = this::multiplyBlock;
        private final Workers.Task dotTask = this::dotBlock;
        private double[] left;
        private double[] other;

        VelocitySolver() {
            super(x.length, x.length);
        }

        @Override
        protected void multiply(double[] u, double[] out) {
            left = u;
            other = out;
            system.workers().run(partial.length, multiplyTask);
            // Without a lambda, which would be an object a product.
            Optional<SelectiveMass> group = system.selectiveMass();
            if (group.isPresent()) {
                double damped = 1 + h * group.get().dampingRate(viscosity);
                group.get().addInertia(damped, u, out);
            }
        }

        private void multiplyBlock(int block) {
            double[] mass = system.masses();
            Arrays.fill(other, 3 * layout.start(block), 3 * layout.end(block), 0);
            system.addStiffness(x, left, other, block);
            for (int n = layout.start(block); n < layout.end(block); n++) {
                double own = mass[n] + h * viscosity[n];
                for (int i = 3 * n; i < 3 * n + 3; i++) {
                    other[i] = inverseMass[n] == 0 ? 0 : own * left[i] + h * h * other[i];
                }
            }
        }

        @Override
        protected void precondition(double[] u, double[] out) {
            for (int i = 0; i < out.length; i++) {
                out[i] = u[i] * diagonal[i / 3];
            }
        }

        @Override
        protected double dot(double[] a, double[] b) {
            left = a;
            other = b;
            system.workers().run(partial.length, dotTask);
            double sum = 0;
            for (double part : partial) {
                sum += part;
            }
            return sum;
        }

        private void dotBlock(int block) {
            double sum = 0;
            for (int i = 3 * layout.start(block); i < 3 * layout.end(block); i++) {
                sum += left[i] * other[i];
            }
            partial[block] = sum;
        }
    }

    static double[][] amplification(double a, double b, double c) {
        double inverse = 1 / (1 + b + a);
        // v' h = ((1 - c) v h - a x) / (1 + b + a), x' = x + v' h.
        return new double[][] {{1 - a * inverse, (1 - c) * inverse}, {-a * inverse, (1 - c) * inverse}};
    }
}
