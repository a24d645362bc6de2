package org.phrenic.patient.diaphragm;

import java.util.Arrays;

/**
 * A smooth function on a regular grid that approximates scattered data: the minimiser of
 *
 * <p>{@code Σ w (h - d)² + L⁴ Σ (h_xx² + 2 h_xy² + h_yy²) + T² Σ h_y²}
 *
 * <p>over the grid's nodes, with natural boundary conditions. {@code L} is the smoothing length and {@code T} that of
 * the tension along columns, without which the function keeps its slope beyond the data. Where no data are near, the
 * function is a thin plate. The normal equations are solved by conjugate gradients, from a solution on a grid of twice
 * the spacing.
 */
final class ThinPlateGrid {
    private static final int LEAST_NODES = 12;
    private static final int MOST_ITERATIONS = 400;
    private static final double TOLERANCE = 1e-5;

    private final int columns;
    private final int rows;
    private final double perXx;
    private final double perXy;
    private final double perYy;
    private final boolean periodic;
    private final double[] weight;
    private final double plate;
    private final double tension;

    /** Weighted second differences along rows, one per node. */
    private final double[] bentX;

    /** Weighted differences along columns; the first row and the last are beyond the grid and zero. */
    private final double[] bentY;

    private final double[] stretched;
    private final double[] twisted;

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
        boolean isDivisible() {
            return columns >= 2 * LEAST_NODES && rows >= 2 * LEAST_NODES && columns % 2 == 0 && rows % 2 == 0;
        }

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
        double mean() {
            double total = 0;
            double sum = 0;
            for (int i = 0; i < value.length; i++) {
                total += weight[i];
                sum += weight[i] > 0 ? weight[i] * value[i] : 0;
            }
            return total > 0 ? sum / total : 0;
        }

        /** Means of four nodes; the weight of a node stands for four times the area. */
        Data coarser(int columns) {
            double[] means = new double[value.length / 4];
            double[] weights = new double[value.length / 4];
            for (int k = 0; k < value.length; k++) {
                int c = k % columns / 2 + columns / 2 * (k / columns / 2);
                weights[c] += weight[k];
                means[c] += weight[k] > 0 ? weight[k] * value[k] : 0;
            }
            for (int c = 0; c < means.length; c++) {
                means[c] /= Math.max(weights[c], Double.MIN_NORMAL);
                weights[c] /= 4;
            }
            return new Data(means, weights);
        }
    }

    private ThinPlateGrid(Grid grid, double[] weight, Stiffness stiffness) {
        columns = grid.columns();
        rows = grid.rows();
        periodic = grid.periodic();
        this.weight = weight;
        perXx = 1 / (grid.stepX() * grid.stepX());
        perXy = 1 / (grid.stepX() * grid.stepY());
        perYy = 1 / (grid.stepY() * grid.stepY());
        plate = StrictMath.pow(stiffness.bendingMm(), 4);
        tension = stiffness.tensionMm() * stiffness.tensionMm() * perYy;
        bentX = new double[columns * rows];
        bentY = new double[columns * (rows + 2)];
        stretched = new double[columns * (rows + 2)];
        twisted = new double[columns * (rows + 2)];
    }

    /**
     * Solves for the values at all nodes; node (i, j) has the index {@code i + columns j}.
     *
     * @param start solution for similar data, from which fewer iterations are needed; empty for none
     */
    static double[] solve(Grid grid, Data data, Stiffness stiffness, double[] start) {
        return new ThinPlateGrid(grid, data.weight(), stiffness)
                .conjugateGradients(data.value(), start.length > 0 ? start : coarseStart(grid, data, stiffness));
    }

    private static double[] coarseStart(Grid grid, Data data, Stiffness stiffness) {
        if (grid.isDivisible()) {
            return refine(solve(grid.coarser(), data.coarser(grid.columns()), stiffness, new double[0]), grid);
        }
        double[] start = new double[grid.columns() * grid.rows()];
        Arrays.fill(start, data.mean());
        return start;
    }

    /** Bilinear interpolation; a coarse node lies in the middle of four fine ones. */
    private static double[] refine(double[] coarse, Grid grid) {
        int columns = grid.columns();
        int rows = grid.rows();
        boolean periodic = grid.periodic();
        int half = columns / 2;
        int low = rows / 2;
        double[] fine = new double[columns * rows];
        for (int j = 0; j < rows; j++) {
            int nearJ = j / 2;
            int farJ = Math.max(0, Math.min(low - 1, j % 2 == 0 ? nearJ - 1 : nearJ + 1));
            for (int i = 0; i < columns; i++) {
                int nearI = i / 2;
                int far = i % 2 == 0 ? nearI - 1 : nearI + 1;
                int farI = periodic ? Math.floorMod(far, half) : Math.max(0, Math.min(half - 1, far));
                fine[i + columns * j] = 0.5625 * coarse[nearI + half * nearJ]
                        + 0.1875 * (coarse[farI + half * nearJ] + coarse[nearI + half * farJ])
                        + 0.0625 * coarse[farI + half * farJ];
            }
        }
        return fine;
    }

    private double[] conjugateGradients(double[] data, double[] start) {
        int n = start.length;
        double[] x = start.clone();
        double[] diagonal = diagonal();
        double[] product = new double[n];
        apply(x, product);
        double[] residual = new double[n];
        double[] direction = new double[n];
        double dot = 0;
        double scale = 0;
        for (int i = 0; i < n; i++) {
            double right = weight[i] > 0 ? weight[i] * data[i] : 0;
            residual[i] = right - product[i];
            diagonal[i] = Math.max(diagonal[i], Double.MIN_NORMAL);
            direction[i] = residual[i] / diagonal[i];
            dot += residual[i] * direction[i];
            scale += right * right / diagonal[i];
        }
        for (int k = 0; k < MOST_ITERATIONS && dot > TOLERANCE * TOLERANCE * scale; k++) {
            apply(direction, product);
            double curvature = 0;
            for (int i = 0; i < n; i++) {
                curvature += direction[i] * product[i];
            }
            if (!(curvature > 0)) {
                break;
            }
            double step = dot / curvature;
            double next = 0;
            for (int i = 0; i < n; i++) {
                x[i] += step * direction[i];
                residual[i] -= step * product[i];
                next += residual[i] * residual[i] / diagonal[i];
            }
            double turn = next / dot;
            dot = next;
            for (int i = 0; i < n; i++) {
                direction[i] = residual[i] / diagonal[i] + turn * direction[i];
            }
        }
        return x;
    }

    /**
     * Multiplies by the matrix of the normal equations: first the weighted differences of each row, then their sum at
     * each node.
     */
    private void apply(double[] h, double[] out) {
        for (int j = 0; j < rows; j++) {
            bendRow(h, columns * j);
            if (j > 0 && j < rows - 1) {
                bendColumns(h, columns * j);
            }
            if (j < rows - 1) {
                stretchAndTwistRow(h, columns * j);
            }
        }
        for (int j = 0; j < rows; j++) {
            sumRow(h, out, columns * j);
        }
    }

    private void bendRow(double[] h, int row) {
        double factor = plate * perXx * perXx;
        int last = row + columns - 1;
        for (int at = row + 1; at < last; at++) {
            bentX[at] = factor * (h[at - 1] - 2 * h[at] + h[at + 1]);
        }
        if (periodic) {
            bentX[row] = factor * (h[last] - 2 * h[row] + h[row + 1]);
            bentX[last] = factor * (h[last - 1] - 2 * h[last] + h[row]);
        }
    }

    private void bendColumns(double[] h, int row) {
        double factor = plate * perYy * perYy;
        for (int at = row; at < row + columns; at++) {
            bentY[at + columns] = factor * (h[at - columns] - 2 * h[at] + h[at + columns]);
        }
    }

    private void stretchAndTwistRow(double[] h, int row) {
        double factor = 2 * plate * perXy * perXy;
        int last = row + columns - 1;
        for (int at = row; at <= last; at++) {
            stretched[at + columns] = tension * (h[at] - h[at + columns]);
        }
        for (int at = row; at < last; at++) {
            twisted[at + columns] = factor * (h[at] - h[at + 1] - h[at + columns] + h[at + columns + 1]);
        }
        if (periodic) {
            twisted[last + columns] = factor * (h[last] - h[row] - h[last + columns] + h[row + columns]);
        }
    }

    private void sumRow(double[] h, double[] out, int row) {
        int last = row + columns - 1;
        for (int at = row + 1; at < last; at++) {
            int above = at + columns;
            double sum = weight[at] * h[at] + twisted[at - 1] + bentY[at] - stretched[at] - twisted[at];
            sum = sum + bentX[at - 1] - twisted[above - 1] - 2 * bentX[at] - 2 * bentY[above];
            out[at] = sum + stretched[above] + twisted[above] + bentX[at + 1] + bentY[above + columns];
        }
        int up = row + columns;
        double sum = weight[row] * h[row] + bentY[row] - stretched[row] - twisted[row] + twisted[last];
        sum = sum - 2 * bentX[row] - 2 * bentY[up] + stretched[up] + twisted[up] + bentX[row + 1];
        out[row] = sum + bentX[last] - twisted[last + columns] + bentY[up + columns];
        up = last + columns;
        sum = weight[last] * h[last] + twisted[last - 1] + bentY[last] - stretched[last] - twisted[last];
        sum = sum + bentX[row] + bentX[last - 1] - twisted[up - 1] - 2 * bentX[last] - 2 * bentY[up];
        out[last] = sum + stretched[up] + twisted[up] + bentY[up + columns];
    }

    /** The diagonal of the matrix. */
    private double[] diagonal() {
        double[] diagonal = weight.clone();
        double bendX = plate * perXx * perXx;
        double bendY = plate * perYy * perYy;
        double twist = 2 * plate * perXy * perXy;
        for (int at = 0; at < diagonal.length; at++) {
            int i = at % columns;
            int j = at / columns;
            int right = i < columns - 1 ? at + 1 : at + 1 - columns;
            if (periodic || (i > 0 && i < columns - 1)) {
                diagonal[i > 0 ? at - 1 : at - 1 + columns] += bendX;
                diagonal[at] += 4 * bendX;
                diagonal[right] += bendX;
            }
            if (j > 0 && j < rows - 1) {
                diagonal[at - columns] += bendY;
                diagonal[at] += 4 * bendY;
                diagonal[at + columns] += bendY;
            }
            if (j < rows - 1) {
                diagonal[at] += tension;
                diagonal[at + columns] += tension;
            }
            if (j < rows - 1 && (periodic || i < columns - 1)) {
                diagonal[at] += twist;
                diagonal[right] += twist;
                diagonal[at + columns] += twist;
                diagonal[right + columns] += twist;
            }
        }
        return diagonal;
    }
}
