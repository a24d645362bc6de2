package org.phrenic.engine.integrator;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/**
 * Largest absolute eigenvalue of a small matrix. 2x2 and 3x3 matrices use the characteristic polynomial, which is more
 * accurate than QR iterations near double roots. Larger matrices use QR iterations.
 */
final class SpectralRadius {
    private SpectralRadius() {}

    static double of(double[][] m) {
        if (m.length == 2) {
            return block(m[0][0], m[0][1], m[1][0], m[1][1]);
        }
        if (m.length > 3) {
            return iterated(m);
        }
        if (m[1][0] == 0 && m[2][0] == 0) {
            // A mode without stiffness: its eigenvalue is separate. The cubic polynomial would mix it with a
            // neighbouring one, and near a double root half of the digits are lost.
            return Math.max(Math.abs(m[0][0]), block(m[1][1], m[1][2], m[2][1], m[2][2]));
        }
        double trace = m[0][0] + m[1][1] + m[2][2];
        double minors = m[0][0] * m[1][1]
                - m[0][1] * m[1][0]
                + m[0][0] * m[2][2]
                - m[0][2] * m[2][0]
                + m[1][1] * m[2][2]
                - m[1][2] * m[2][1];
        double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
                - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
        double real = realRoot(trace, minors, determinant);
        // Dividing the polynomial by (λ - real) gives λ² - (trace - real) λ + (minors - real (trace - real)).
        double t = trace - real;
        double d = minors - real * t;
        return Math.max(Math.abs(real), quadratic(t, d, t * t - 4 * d));
    }

    /** By QR iterations; NaN if the matrix is not finite. */
    private static double iterated(double[][] m) {
        EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(m.length, false);
        if (!eigen.decompose(new DMatrixRMaj(m))) {
            return Double.NaN;
        }
        double largest = 0;
        for (int i = 0; i < m.length; i++) {
            largest = Math.max(largest, eigen.getEigenvalue(i).getMagnitude());
        }
        return largest;
    }

    /**
     * Of a 2x2 matrix. The discriminant is computed from the entries, which is accurate for nearly equal eigenvalues.
     */
    private static double block(double p, double q, double r, double s) {
        return quadratic(p + s, p * s - q * r, (p - s) * (p - s) + 4 * q * r);
    }

    /** Larger absolute root of λ² - t λ + d. */
    private static double quadratic(double t, double d, double discriminant) {
        return discriminant < 0 ? Math.sqrt(d) : 0.5 * (Math.abs(t) + Math.sqrt(discriminant));
    }

    /** A real root of λ³ - t λ² + m λ - d, by bisection within Cauchy's bound. */
    private static double realRoot(double t, double m, double d) {
        double high = 1 + Math.max(Math.abs(t), Math.max(Math.abs(m), Math.abs(d)));
        double low = -high;
        for (int i = 0; i < 120; i++) {
            double middle = 0.5 * (low + high);
            if (((middle - t) * middle + m) * middle - d > 0) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return 0.5 * (low + high);
    }
}
