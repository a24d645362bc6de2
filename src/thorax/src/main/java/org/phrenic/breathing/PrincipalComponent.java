package org.phrenic.breathing;

import java.util.Arrays;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/**
 * The first principal component of a marker's motion: its displacement along the direction of largest variance. The
 * sign is chosen for a positive third central moment, so that larger is deeper, because people rest longer at
 * end-expiration than at end-inspiration.
 */
final class PrincipalComponent {
    private PrincipalComponent() {}

    private static boolean moves(List<double[]> rows, int column) {
        double[] first = rows.isEmpty() ? null : rows.get(0);
        return rows.stream().anyMatch(row -> !Arrays.equals(row, column, column + 3, first, column, column + 3));
    }

    /**
     * Computes the signal from rows that hold x, y, z starting at a column.
     *
     * @throws IllegalArgumentException if there are no rows or the marker does not move
     */
    static double[] firstComponent(String name, List<double[]> rows, int column) {
        int count = rows.size();
        if (!moves(rows, column)) {
            throw new IllegalArgumentException(name + ": found no motion of a marker, expected rows of positions");
        }
        double[] mean = new double[3];
        for (double[] row : rows) {
            for (int i = 0; i < 3; i++) {
                mean[i] += row[column + i] / count;
            }
        }
        DMatrixRMaj covariance = new DMatrixRMaj(3, 3);
        for (double[] row : rows) {
            for (int i = 0; i < 3; i++) {
                for (int j = 0; j < 3; j++) {
                    covariance.add(i, j, (row[column + i] - mean[i]) * (row[column + j] - mean[j]));
                }
            }
        }
        EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(3, true, true);
        if (!eigen.decompose(covariance)) {
            throw new IllegalArgumentException(name + ": found positions without a principal axis, expected a path");
        }
        int largest = 0;
        for (int i = 1; i < 3; i++) {
            if (eigen.getEigenvalue(i).getReal() > eigen.getEigenvalue(largest).getReal()) {
                largest = i;
            }
        }
        double[] direction = eigen.getEigenVector(largest).data;
        double[] signal = new double[count];
        double third = 0;
        for (int n = 0; n < count; n++) {
            for (int i = 0; i < 3; i++) {
                signal[n] += direction[i] * (rows.get(n)[column + i] - mean[i]);
            }
            third += signal[n] * signal[n] * signal[n];
        }
        if (third < 0) {
            Arrays.setAll(signal, n -> -signal[n]);
        }
        return signal;
    }
}
