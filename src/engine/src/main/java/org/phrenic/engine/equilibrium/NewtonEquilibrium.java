package org.phrenic.engine.equilibrium;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.math.ConjugateGradient;
import org.phrenic.engine.math.DenseVectors;

/**
 * Static equilibrium of a particle system under its constraints, by a matrix-free Newton-Krylov method (Knoll and Keyes
 * 2004, doi 10.1016/j.jcp.2003.08.010). It solves P f(x) = 0 at a fixed time, where P projects onto the directions that
 * the active constraints allow.
 *
 * <pre>
 * P (K + σ M) P d = P f        x ← x + α d, then projection onto the constraints
 * K u = -(g(x + ε u) - g(x - ε u)) / 2 ε,    g = f - Cᵀ λ with λ fixed at its value at x
 * </pre>
 *
 * <p>Each linear system is solved by conjugate gradients. The tolerance decreases with the residual (Eisenstat and
 * Walker 1996, doi 10.1137/0917003), which gives convergence of order 2. The line search halves α until the residual
 * decreases.
 *
 * <p>If K is not positive in some direction, or no α decreases the residual, the shift σ is switched on. Each step is
 * then a backward Euler step of length 1/√σ from velocity 0 (pseudo-transient continuation: Kelley and Keyes 1998, doi
 * 10.1137/S0036142996304796). During such steps the residual may grow, and the active set is updated after every step.
 * σ decreases with the residual.
 *
 * <p>Contact planes, sheet normals and anchors are evaluated once and then kept fixed. The active set is updated after
 * each converged Newton solve until it no longer changes: rows that would have to pull are released, violated rows
 * become active. This outer loop may not converge, for instance where a node alternates between contact and separation
 * or where a fold snaps through. It then ends at its limit, and the result reports it.
 */
public final class NewtonEquilibrium {
    private static final int MAX_ITERATIONS = 80;
    private static final int MAX_KRYLOV = 3000;
    private static final int MAX_HALVINGS = 6;
    /** Largest displacement in the finite differences of forces, mm. */
    private static final double DIFFERENCE_MM = 1e-3;
    /** Loosest and tightest tolerance of conjugate gradients, as a fraction of the residual. */
    private static final double LOOSEST = 0.1;

    private static final double TIGHTEST = 1e-7;
    private static final double FIRST_SHIFT = 1;
    private static final double MAX_SHIFT = 1e8;
    private static final double RAISE = 10;
    private static final double LOWER = 3;
    /** Largest growth factor of the residual in one shifted step. Crossing a fold requires some growth. */
    private static final double GROWTH = 1.5;

    /** Distance from the wall below which a contact is initially active, mm. */
    private static final double ACTIVE_GAP_MM = 0.02;

    private static final int FIRST_CHOICES = 5;

    /** Pulling force above which a contact is released, mN. */
    private static final double PULL_MN = 1e-6;

    private static final double NO_TIME_S = 1e-9;

    private final ParticleSystem system;
    private final double timeS;
    private final double[] x;
    private final double[] still;
    private final double[] force;
    private final double[] ahead;
    private final double[] behind;
    private final double[] residual;
    private final double[] step;
    private final double[] kept;
    private final double[] here;
    private final double[] stiffness;
    private double[] lambda = {};
    private final ActiveConstraints rows;
    private final StepSolver stepSolver;
    private final int freeCount;
    private double shift;

    /**
     * Outcome of a solve.
     *
     * @param converged whether forces balance to the tolerance
     * @param activeSetSettled whether the active set is consistent with the solution; false without one
     * @param residualsMn residual force on free nodes, rms, before each Newton step of the last round and after the
     *     last step, mN
     * @param activeRows active rows of the solution
     * @param activeSetChanges rows whose active state is inconsistent with the solution; 0 without one
     */
    public record Result(
            boolean converged, boolean activeSetSettled, double[] residualsMn, int activeRows, int activeSetChanges) {}

    /**
     * Sets all velocities to 0.
     *
     * @param system a system near equilibrium; its positions are changed
     * @param timeS time at which prescribed motion is evaluated, s
     * @param mayMove for each node in the caller's numbering, whether it is free; the others stay fixed
     */
    public NewtonEquilibrium(ParticleSystem system, double timeS, boolean[] mayMove) {
        this.system = system;
        this.timeS = timeS;
        x = system.positions();
        still = new double[x.length];
        force = new double[x.length];
        ahead = new double[x.length];
        behind = new double[x.length];
        residual = new double[x.length];
        step = new double[x.length];
        kept = new double[x.length];
        here = new double[x.length];
        stiffness = new double[system.nodeCount()];
        boolean[] isFree = new boolean[system.nodeCount()];
        int count = 0;
        for (int n = 0; n < isFree.length; n++) {
            isFree[n] = system.inverseMasses()[n] > 0 && mayMove[system.layout().caller(n)];
            count += isFree[n] ? 1 : 0;
        }
        freeCount = count;
        rows = new ActiveConstraints(system, isFree);
        stepSolver = new StepSolver();
        Arrays.fill(system.velocities(), 0);
    }

    /**
     * Puts prescribed nodes where they are at the time of the equilibrium, then alternates Newton solves and active-set
     * updates until the active set no longer changes.
     *
     * @param toleranceMn bound of the residual, rms over free nodes, mN
     * @param mostRounds maximum number of rounds, at least 1
     */
    public Result findEquilibrium(double toleranceMn, int mostRounds) {
        // Time does not advance, so kept planes, normals and anchors must be evaluated afresh.
        system.invalidate();
        system.applyPrescribed(timeS, x, system.velocities());
        system.project(timeS, NO_TIME_S);
        Arrays.fill(system.velocities(), 0);
        rows.collect();
        int changed = rows.updateActiveSet(ACTIVE_GAP_MM, null, 0);
        for (int i = 0; i < FIRST_CHOICES && changed > 0; i++) {
            projectPositions();
            evaluateResidual();
            changed = rows.updateActiveSet(0, lambda, PULL_MN);
        }
        List<Double> history = new ArrayList<>();
        boolean converged = newton(toleranceMn, history);
        int activeRows = rows.activeCount();
        changed = converged ? rows.updateActiveSet(0, lambda, PULL_MN) : 0;
        for (int round = 1; changed > 0 && round < mostRounds; round++) {
            history.clear();
            converged = newton(toleranceMn, history);
            activeRows = rows.activeCount();
            changed = converged ? rows.updateActiveSet(0, lambda, PULL_MN) : 0;
        }
        return new Result(
                converged,
                converged && changed == 0,
                history.stream().mapToDouble(Double::doubleValue).toArray(),
                activeRows,
                changed);
    }

    private boolean newton(double toleranceMn, List<Double> history) {
        shift = 0;
        rows.factorise();
        projectPositions();
        double norm = evaluateResidual();
        history.add(norm);
        double before = norm;
        for (int i = 0; i < MAX_ITERATIONS && norm > toleranceMn; i++) {
            double ratio = norm / before;
            double tolerance = Math.max(TIGHTEST, Math.min(LOOSEST, history.size() == 1 ? LOOSEST : ratio * ratio));
            before = norm;
            System.arraycopy(x, 0, kept, 0, x.length);
            double next = Double.NaN;
            while (Double.isNaN(next)) {
                if (shift > MAX_SHIFT) {
                    System.arraycopy(kept, 0, x, 0, x.length);
                    evaluateResidual();
                    return false;
                }
                next = solve(tolerance) ? lineSearch(norm) : Double.NaN;
                shift = Double.isNaN(next)
                        ? Math.max(FIRST_SHIFT, RAISE * shift)
                        : next < norm ? reducedShift() : shift;
            }
            if (shift > 0 && rows.updateActiveSet(0, lambda, PULL_MN) > 0) {
                projectPositions();
                next = evaluateResidual();
            }
            norm = next;
            history.add(norm);
        }
        return norm <= toleranceMn;
    }

    private double reducedShift() {
        return shift <= FIRST_SHIFT ? 0 : shift / LOWER;
    }

    /** Moves nodes until the active rows hold, updating the normals of links after each iteration. */
    private void projectPositions() {
        for (int i = 0; i < 3; i++) {
            rows.collect();
            rows.factorise();
            rows.projectPositions(x);
        }
        rows.collect();
        rows.factorise();
    }

    /** Evaluates forces, multipliers and the residual P f at x; returns its rms over free nodes, mN. */
    private double evaluateResidual() {
        system.forces(timeS, x, still, force);
        lambda = rows.multipliers(force).clone();
        System.arraycopy(force, 0, residual, 0, force.length);
        rows.project(residual);
        return Math.sqrt(DenseVectors.dot(residual, residual) / freeCount);
    }

    /** Backtracking line search; returns the residual at the first step that decreases it, else NaN. */
    private double lineSearch(double norm) {
        double alpha = 1;
        for (int i = 0; i < MAX_HALVINGS; i++) {
            for (int k = 0; k < x.length; k++) {
                x[k] = kept[k] + alpha * step[k];
            }
            projectPositions();
            double next = evaluateResidual();
            if (next < (shift > 0 ? GROWTH * norm : (1 - 1e-4 * alpha) * norm)) {
                return next;
            }
            alpha /= 2;
        }
        System.arraycopy(kept, 0, x, 0, x.length);
        projectPositions();
        evaluateResidual();
        return Double.NaN;
    }

    /** Solves for the Newton step by conjugate gradients; false if K + σ M is not positive definite. */
    private boolean solve(double tolerance) {
        Arrays.fill(stiffness, 0);
        system.addRowSums(stiffness, new double[stiffness.length]);
        Arrays.fill(step, 0);
        double[] left = residual.clone();
        stepSolver.start(left);
        return stepSolver.solve(step, left, tolerance * tolerance * DenseVectors.dot(left, left), MAX_KRYLOV);
    }

    /** The operator P (K + σ M) P with its diagonal as preconditioner. */
    private final class StepSolver extends ConjugateGradient {
        private final double[] mass = system.masses();

        StepSolver() {
            super(x.length, x.length);
        }

        @Override
        protected double stopMeasure(double rho, double[] left) {
            return DenseVectors.dot(left, left);
        }

        @Override
        protected void precondition(double[] u, double[] out) {
            for (int k = 0; k < u.length; k++) {
                // Half a row sum is the diagonal of a graph Laplacian. Any scale will do for a node without springs.
                double diagonal = 0.5 * stiffness[k / 3] + shift * mass[k / 3];
                out[k] = diagonal > 0 ? u[k] / diagonal : u[k];
            }
            rows.project(out);
        }

        @Override
        protected void multiply(double[] d, double[] out) {
            double greatest = 0;
            for (double each : d) {
                greatest = Math.max(greatest, Math.abs(each));
            }
            double epsilon = DIFFERENCE_MM / greatest;
            difference(d, epsilon, ahead);
            difference(d, -epsilon, behind);
            for (int k = 0; k < out.length; k++) {
                out[k] = (behind[k] - ahead[k]) / (2 * epsilon) + shift * mass[k / 3] * d[k];
            }
            rows.collect();
            rows.project(out);
        }

        /** Evaluates g at x + ε d. */
        private void difference(double[] d, double epsilon, double[] out) {
            System.arraycopy(x, 0, here, 0, x.length);
            DenseVectors.addScaled(x, epsilon, d);
            system.forces(timeS, x, still, out);
            rows.collect();
            rows.addForces(lambda, -1, out);
            System.arraycopy(here, 0, x, 0, x.length);
        }
    }
}
