package org.phrenic.engine.integrator;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/**
 * Largest absolute eigenvalue of a small matrix: of 2x2 and 3x3 from the characteristic polynomial, which near double
 * roots is nearer than an iteration on the matrix; of larger ones by QR iterations.
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
            // A mode without stiffness: its eigenvalue stands alone. The polynomial would mix it with its neighbour,
            // and near a double root it loses half the digits.
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
        // Division by (λ - real) leaves λ² - (trace - real) λ + (minors - real (trace - real)).
        double t = trace - real;
        double d = minors - real * t;
        return Math.max(Math.abs(real), quadratic(t, d, t * t - 4 * d));
    }

    /** NaN where the matrix is not finite. */
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

    /** Of a 2x2 matrix; the discriminant is taken from its entries, which keeps nearly equal eigenvalues apart. */
    private static double block(double p, double q, double r, double s) {
        return quadratic(p + s, p * s - q * r, (p - s) * (p - s) + 4 * q * r);
    }

    /** Larger |root| of λ² - t λ + d. */
    private static double quadratic(double t, double d, double discriminant) {
        if (discriminant < 0) {
            return Math.sqrt(d);
        }
        return 0.5 * (Math.abs(t) + Math.sqrt(discriminant));
    }

    /** A real root of λ³ - t λ² + m λ - d, bracketed by Cauchy's bound and bisected. */
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
