package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The thin plate against a direct solution, against planes, and where there are no data. */
class ThinPlateGridTest {
    private static final ThinPlateGrid.Stiffness OF_CAGE = new ThinPlateGrid.Stiffness(5, 3);

    /** Adds factor (Σ sign h)² of a difference between nodes to a matrix; nodes beyond the grid leave it out. */
    private static void add(DMatrixRMaj a, ThinPlateGrid.Grid grid, double factor, int[][] nodes, double[] signs) {
        int[] at = new int[nodes.length];
        for (int k = 0; k < at.length; k++) {
            int i = grid.periodic() ? Math.floorMod(nodes[k][0], grid.columns()) : nodes[k][0];
            int j = nodes[k][1];
            if (i < 0 || i >= grid.columns() || j < 0 || j >= grid.rows()) {
                return;
            }
            at[k] = i + grid.columns() * j;
        }
        for (int k = 0; k < at.length; k++) {
            for (int l = 0; l < at.length; l++) {
                a.add(at[k], at[l], factor * signs[k] * signs[l]);
            }
        }
    }

    /** The matrix of the energy that the class states, difference by difference. */
    private static DMatrixRMaj matrix(ThinPlateGrid.Grid grid, double[] weight, ThinPlateGrid.Stiffness stiffness) {
        DMatrixRMaj a = CommonOps_DDRM.diag(weight);
        double l4 = Math.pow(stiffness.bendingMm(), 4);
        double hx2 = grid.stepX() * grid.stepX();
        double hy2 = grid.stepY() * grid.stepY();
        double[] second = {1, -2, 1};
        for (int j = 0; j < grid.rows(); j++) {
            for (int i = 0; i < grid.columns(); i++) {
                add(a, grid, l4 / (hx2 * hx2), new int[][] {{i - 1, j}, {i, j}, {i + 1, j}}, second);
                add(a, grid, l4 / (hy2 * hy2), new int[][] {{i, j - 1}, {i, j}, {i, j + 1}}, second);
                int[][] cell = {{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}};
                add(a, grid, 2 * l4 / (hx2 * hy2), cell, new double[] {1, -1, -1, 1});
                double t2 = stiffness.tensionMm() * stiffness.tensionMm();
                add(a, grid, t2 / hy2, new int[][] {{i, j}, {i, j + 1}}, new double[] {1, -1});
            }
        }
        return a;
    }

    /** Weights as a cage has them: bones with gaps between, organs, nothing over a third of the rows. */
    private static double[] weights(ThinPlateGrid.Grid grid) {
        Random random = new Random(3);
        double[] weight = new double[grid.nodes()];
        for (int k = 0; k < weight.length; k++) {
            double kind = random.nextDouble();
            boolean gap = k / grid.columns() > grid.rows() * 2 / 3;
            weight[k] = gap || kind < 0.4 ? 0 : kind < 0.7 ? 1 : kind < 0.9 ? 0.3 : 100;
        }
        return weight;
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void itMinimisesTheEnergy(boolean periodic) {
        ThinPlateGrid.Grid grid = new ThinPlateGrid.Grid(32, 16, 4.3, 3, periodic);
        double[] weight = weights(grid);
        Random random = new Random(5);
        double[] value = random.doubles(weight.length, 90, 140).toArray();
        double[] solved = ThinPlateGrid.solve(grid, new ThinPlateGrid.Data(value, weight), OF_CAGE, new double[0]);
        DMatrixRMaj right = new DMatrixRMaj(weight.length, 1);
        Arrays.setAll(right.data, k -> weight[k] * value[k]);
        DMatrixRMaj found = new DMatrixRMaj(weight.length, 1);
        assertThat(CommonOps_DDRM.solve(matrix(grid, weight, OF_CAGE), right, found))
                .isTrue();
        double[] direct = found.data;
        for (int k = 0; k < direct.length; k++) {
            assertThat(solved[k]).as("node %d, mm", k).isCloseTo(direct[k], within(1e-3));
        }
    }

    /** A plane bends nowhere, so that it goes on across a gap of 350 mm, as wide as what an abdominal scan lacks. */
    @Test
    void aPlaneGoesOnWhereThereAreNoData() {
        ThinPlateGrid.Grid grid = new ThinPlateGrid.Grid(128, 144, 3, 3, false);
        double[] plane = new double[grid.nodes()];
        double[] weight = new double[grid.nodes()];
        for (int k = 0; k < plane.length; k++) {
            plane[k] = 100 + 0.2 * (k % grid.columns()) - 0.1 * (k / grid.columns());
            weight[k] = k / grid.columns() < 26 ? 1 : 0;
        }
        ThinPlateGrid.Stiffness bending = new ThinPlateGrid.Stiffness(10, 0);
        double[] solved = ThinPlateGrid.solve(grid, new ThinPlateGrid.Data(plane, weight), bending, new double[0]);
        for (int k = 0; k < plane.length; k++) {
            assertThat(solved[k]).as("node %d, mm", k).isCloseTo(plane[k], within(0.05));
        }
    }

    /** From the solution of similar data the same function comes out. */
    @Test
    void theStartDoesNotShowInTheSolution() {
        ThinPlateGrid.Grid grid = new ThinPlateGrid.Grid(64, 48, 4.3, 3, true);
        double[] weight = weights(grid);
        double[] value = new Random(7).doubles(weight.length, 90, 140).toArray();
        ThinPlateGrid.Data data = new ThinPlateGrid.Data(value, weight);
        double[] start = new Random(9).doubles(weight.length, 50, 150).toArray();
        assertThat(ThinPlateGrid.solve(grid, data, OF_CAGE, start))
                .usingComparatorWithPrecision(0.02)
                .containsExactly(ThinPlateGrid.solve(grid, data, OF_CAGE, new double[0]));
    }

    /** The factor by which a V-cycle reduces any error, in its energy norm: power iteration of I - B A. */
    @ParameterizedTest
    @ValueSource(ints = {32, 64, 128})
    void aCycleReducesAnyErrorOnAnyGridAlike(int nodes) {
        ThinPlateGrid.Grid grid = new ThinPlateGrid.Grid(nodes, nodes, 4.3, 3, true);
        MultigridCycle cycle = new MultigridCycle(grid, weights(grid), OF_CAGE);
        double[] error = new Random(11).doubles(grid.nodes(), -1, 1).toArray();
        double[] product = new double[error.length];
        double[] correction = new double[error.length];
        double left = 0;
        for (int k = 0; k < 40; k++) {
            cycle.matrix().multiply(error, product);
            double energy = dot(error, product);
            cycle.apply(product, correction);
            for (int i = 0; i < error.length; i++) {
                error[i] -= correction[i];
            }
            cycle.matrix().multiply(error, product);
            left = Math.sqrt(dot(error, product) / energy);
            double scale = 1 / Math.sqrt(dot(error, product));
            Arrays.setAll(error, i -> error[i] * scale);
        }
        assertThat(left).isBetween(0.6, 0.75);
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    @Test
    void aGridWithoutDataIsNoFailure() {
        ThinPlateGrid.Grid grid = new ThinPlateGrid.Grid(32, 32, 3, 3, true);
        double[] none = new double[grid.nodes()];
        assertThat(ThinPlateGrid.solve(grid, new ThinPlateGrid.Data(none, none), OF_CAGE, new double[0]))
                .containsOnly(0);
    }
}
