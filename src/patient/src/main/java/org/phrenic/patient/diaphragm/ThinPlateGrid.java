package org.phrenic.patient.diaphragm;

import java.util.Arrays;
import org.phrenic.engine.math.ConjugateGradient;

/**
 * A smooth function on a regular grid that approximates scattered data: the minimiser of
 *
 * <p>{@code Σ w (h - d)² + L⁴ Σ (h_xx² + 2 h_xy² + h_yy²) + T² Σ h_y²}
 *
 * <p>over the grid's nodes, with natural boundary conditions. {@code L} is the smoothing length and {@code T} that of
 * the tension along columns, without which the function keeps its slope beyond the data. Where no data are near, the
 * function is a thin plate. The normal equations are solved by conjugate gradients with a {@link MultigridCycle} as
 * preconditioner, whose number of iterations depends neither on the number of nodes nor on the size of gaps in the
 * data.
 */
final class ThinPlateGrid {
    private static final int LEAST_NODES = 8;
    private static final int MOST_ITERATIONS = 100;
    /** Error of the solution over the solution, in the norm of the energy: 0.02 mm in the widest gaps of a cage. */
    private static final double TOLERANCE = 1e-7;

    private ThinPlateGrid() {}

    /** Lengths L and T, in the unit of the grid's steps. */
    record Stiffness(double bendingMm, double tensionMm) {}

    /**
     * A grid.
     *
     * @param stepX spacing along columns, mm
     * @param stepY spacing along rows, mm
     * @param periodic whether the last column is next to the first
     */
    record Grid(int columns, int rows, double stepX, double stepY, boolean periodic) {
        int nodes() {
            return columns * rows;
        }

        boolean isDivisible() {
            return columns >= 2 * LEAST_NODES && rows >= 2 * LEAST_NODES && columns % 2 == 0 && rows % 2 == 0;
        }

        /** The grid of twice the spacing. */
        Grid coarser() {
            return new Grid(columns / 2, rows / 2, 2 * stepX, 2 * stepY, periodic);
        }
    }

    /**
     * Data at the nodes.
     *
     * @param value one per node, ignored where the weight is 0
     * @param weight one per node, 0 for no data
     */
    record Data(double[] value, double[] weight) {
        double[] rightHandSide() {
            double[] right = new double[value.length];
            Arrays.setAll(right, i -> weight[i] > 0 ? weight[i] * value[i] : 0);
            return right;
        }
    }

    /**
     * Solves for the values at all nodes; node (i, j) has the index {@code i + columns j}.
     *
     * @param start solution for similar data, from which fewer iterations are needed; empty for none
     */
    static double[] solve(Grid grid, Data data, Stiffness stiffness, double[] start) {
        Solver solver = new Solver(new MultigridCycle(grid, data.weight(), stiffness), grid.nodes());
        double[] residual = data.rightHandSide();
        double goal = TOLERANCE * TOLERANCE * solver.start(residual);
        double[] x = start.length > 0 ? start.clone() : new double[grid.nodes()];
        if (start.length > 0) {
            solver.subtractProduct(x, residual);
            solver.start(residual);
        }
        solver.solve(x, residual, goal, MOST_ITERATIONS);
        return x;
    }

    /** Conjugate gradients for the normal equations. */
    private static final class Solver extends ConjugateGradient {
        private final MultigridCycle cycle;

        Solver(MultigridCycle cycle, int nodes) {
            super(nodes, nodes);
            this.cycle = cycle;
        }

        @Override
        protected void multiply(double[] d, double[] out) {
            cycle.matrix().multiply(d, out);
        }

        @Override
        protected void precondition(double[] residual, double[] out) {
            cycle.apply(residual, out);
        }

        void subtractProduct(double[] x, double[] from) {
            double[] product = new double[x.length];
            multiply(x, product);
            Arrays.setAll(from, i -> from[i] - product[i]);
        }
    }
}
