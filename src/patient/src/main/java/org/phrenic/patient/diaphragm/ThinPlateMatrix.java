package org.phrenic.patient.diaphragm;

/**
 * The matrix of the normal equations of a {@link ThinPlateGrid}: {@code W + L⁴ (δxxᵀ δxx + 2 δxyᵀ δxy + δyyᵀ δyy) + T²
 * δyᵀ δy} with the weights W of the data, natural at the boundary.
 */
final class ThinPlateMatrix {
    /** Bound of the eigenvalues of D⁻¹ A, D the diagonal of A: that of a twist, the greatest of all differences. */
    static final double GREATEST_EIGENVALUE = 4;

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

    ThinPlateMatrix(ThinPlateGrid.Grid grid, double[] weight, ThinPlateGrid.Stiffness stiffness) {
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

    /** Multiplies by the matrix: first the weighted differences of each row, then their sum at each node. */
    void multiply(double[] h, double[] out) {
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
    double[] diagonal() {
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
