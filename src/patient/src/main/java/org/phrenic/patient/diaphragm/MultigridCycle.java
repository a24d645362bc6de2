package org.phrenic.patient.diaphragm;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * A multigrid V-cycle for the equations of a {@link ThinPlateGrid} (Briggs, Henson and McCormick 2000, doi
 * 10.1137/1.9780898719505): a symmetric, positive definite approximation of A⁻¹. Each level has half the columns and
 * rows of the one above and its own {@link ThinPlateMatrix}. A Chebyshev polynomial of D⁻¹ A smooths before and after
 * the correction of the coarser level. Corrections are interpolated bilinearly, which keeps their slope continuous;
 * residuals are restricted by the transpose. The coarsest level is solved by a Cholesky factorisation.
 */
final class MultigridCycle {
    private final ThinPlateGrid.Grid grid;
    private final ThinPlateMatrix matrix;
    private final double[] diagonal;
    private final double[] product;
    private final Inverse inverse;

    /** An approximation of A⁻¹. */
    private interface Inverse {
        /** Writes A⁻¹ b to {@code x}. */
        void apply(double[] b, double[] x);
    }

    MultigridCycle(ThinPlateGrid.Grid grid, double[] weight, ThinPlateGrid.Stiffness stiffness) {
        this.grid = grid;
        matrix = new ThinPlateMatrix(grid, weight, stiffness);
        diagonal = matrix.diagonal();
        product = new double[grid.nodes()];
        inverse = grid.isDivisible() ? new SmoothedCorrection(weight, stiffness) : new Factors();
    }

    ThinPlateMatrix matrix() {
        return matrix;
    }

    /** Writes an approximation of A⁻¹ b to {@code x}. */
    void apply(double[] b, double[] x) {
        inverse.apply(b, x);
    }

    /** The solution on the coarsest level. */
    private final class Factors implements Inverse {
        /** Added to the diagonal, over its mean, so that a grid without data has a solution. */
        private static final double RIDGE = 1e-12;

        private final LinearSolverDense<DMatrixRMaj> solver;

        Factors() {
            int n = grid.nodes();
            DMatrixRMaj dense = new DMatrixRMaj(n, n);
            double ridge = RIDGE * Arrays.stream(diagonal).average().orElseThrow();
            double[] unit = new double[n];
            for (int j = 0; j < n; j++) {
                unit[j] = 1;
                matrix.multiply(unit, product);
                unit[j] = 0;
                for (int i = 0; i < n; i++) {
                    dense.unsafe_set(i, j, product[i]);
                }
                dense.add(j, j, ridge);
            }
            solver = LinearSolverFactory_DDRM.symmPosDef(n);
            if (!solver.setA(dense)) {
                throw new IllegalStateException("a thin plate of " + n + " nodes without a solution");
            }
        }

        @Override
        public void apply(double[] b, double[] x) {
            solver.solve(DMatrixRMaj.wrap(b.length, 1, b), DMatrixRMaj.wrap(x.length, 1, x));
        }
    }

    /** Smoothing before and after a correction from the grid of twice the spacing. */
    private final class SmoothedCorrection implements Inverse {
        /** Degree of the smoothing polynomial. */
        private static final int DEGREE = 3;

        /**
         * Greatest over least eigenvalue of D⁻¹ A that the polynomial reduces. Waves of four nodes, the shortest that
         * the coarser level represents, have an eigenvalue of 0.2, the shortest have 3.2.
         */
        private static final double SMOOTHED = 20;

        /** Area of a node of the coarser level, in areas of a node. */
        private static final int AREA = 4;

        /** Shares of the nearer and the farther coarse node along an axis; a coarse one lies amid four fine ones. */
        private static final double NEAR = 0.75;

        private static final double FAR = 0.25;

        private final double[] residual = new double[grid.nodes()];
        private final double[] change = new double[grid.nodes()];
        private final int columns = grid.columns() / 2;
        private final int rows = grid.rows() / 2;
        private final double[] right = new double[columns * rows];
        private final double[] found = new double[columns * rows];
        private final MultigridCycle coarser;

        SmoothedCorrection(double[] weight, ThinPlateGrid.Stiffness stiffness) {
            double[] mean = new double[columns * rows];
            for (int k = 0; k < weight.length; k++) {
                mean[k % grid.columns() / 2 + columns * (k / grid.columns() / 2)] += weight[k] / AREA;
            }
            coarser = new MultigridCycle(grid.coarser(), mean, stiffness);
        }

        @Override
        public void apply(double[] b, double[] x) {
            Arrays.fill(x, 0);
            System.arraycopy(b, 0, residual, 0, b.length);
            smooth(x);
            updateResidual();
            restrict();
            coarser.apply(right, found);
            interpolate();
            addChange(x);
            updateResidual();
            smooth(x);
        }

        private void addChange(double[] x) {
            for (int i = 0; i < x.length; i++) {
                x[i] += change[i];
            }
        }

        /** Takes the product of the change from the residual. */
        private void updateResidual() {
            matrix.multiply(change, product);
            for (int i = 0; i < residual.length; i++) {
                residual[i] -= product[i];
            }
        }

        /**
         * Chebyshev iteration (Saad 2003, doi 10.1137/1.9780898718003, algorithm 12.1). The residual is that before the
         * last change.
         */
        private void smooth(double[] x) {
            double upper = ThinPlateMatrix.GREATEST_EIGENVALUE;
            double lower = upper / SMOOTHED;
            double theta = 0.5 * (upper + lower);
            double delta = 0.5 * (upper - lower);
            double rho = delta / theta;
            for (int i = 0; i < x.length; i++) {
                change[i] = residual[i] / (theta * diagonal[i]);
            }
            addChange(x);
            for (int k = 1; k < DEGREE; k++) {
                updateResidual();
                double next = 1 / (2 * theta / delta - rho);
                double keep = next * rho;
                double step = 2 * next / delta;
                for (int i = 0; i < x.length; i++) {
                    change[i] = keep * change[i] + step * residual[i] / diagonal[i];
                }
                addChange(x);
                rho = next;
            }
        }

        /** The residual on the coarser level, whose nodes have the energy of their area. */
        private void restrict() {
            Arrays.fill(right, 0);
            for (int j = 0; j < grid.rows(); j++) {
                int near = columns * (j / 2);
                int far = columns * farRow(j);
                for (int i = 0; i < grid.columns(); i++) {
                    double r = residual[i + grid.columns() * j] / AREA;
                    int farColumn = farColumn(i);
                    right[near + i / 2] += NEAR * NEAR * r;
                    right[near + farColumn] += NEAR * FAR * r;
                    right[far + i / 2] += FAR * NEAR * r;
                    right[far + farColumn] += FAR * FAR * r;
                }
            }
        }

        /** The change that the coarser level found. */
        private void interpolate() {
            for (int j = 0; j < grid.rows(); j++) {
                int near = columns * (j / 2);
                int far = columns * farRow(j);
                for (int i = 0; i < grid.columns(); i++) {
                    int farColumn = farColumn(i);
                    change[i + grid.columns() * j] = NEAR * (NEAR * found[near + i / 2] + FAR * found[near + farColumn])
                            + FAR * (NEAR * found[far + i / 2] + FAR * found[far + farColumn]);
                }
            }
        }

        private int farRow(int j) {
            return Math.max(0, Math.min(rows - 1, j % 2 == 0 ? j / 2 - 1 : j / 2 + 1));
        }

        private int farColumn(int i) {
            int far = i % 2 == 0 ? i / 2 - 1 : i / 2 + 1;
            return grid.periodic() ? Math.floorMod(far, columns) : Math.max(0, Math.min(columns - 1, far));
        }
    }
}
