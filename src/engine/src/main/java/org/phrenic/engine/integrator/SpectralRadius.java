package org.phrenic.engine.integrator;

/**
 * Largest absolute eigenvalue of a small matrix: of 2x2 and 3x3 from the characteristic polynomial, of larger ones from
 * the growth of powers.
 */
final class SpectralRadius {
    /** Powers up to M^(2^40): what growth like that of a double root adds to the logarithm is then below 1e-10. */
    private static final int SQUARINGS = 40;

    /** A power this small settles that all eigenvalues are below 1. */
    private static final double GONE = 1e-3;

    private SpectralRadius() {}

    static double of(double[][] m) {
        if (m.length == 2) {
            return block(m[0][0], m[0][1], m[1][0], m[1][1]);
        }
        if (m.length > 3) {
            return ofPowers(m);
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

    /** lim |M^n|^(1/n), n a power of two; an upper bound below 1 as soon as a power shows that it is below 1. */
    private static double ofPowers(double[][] m) {
        double[][] power = m;
        double logarithm = 0;
        double n = 1;
        for (int i = 0; i < SQUARINGS; i++) {
            double norm = 0;
            for (double[] row : power) {
                double sum = 0;
                for (double entry : row) {
                    sum += Math.abs(entry);
                }
                norm = Math.max(norm, sum);
            }
            if (!(norm > 0 && norm < Double.POSITIVE_INFINITY)) {
                return norm;
            }
            logarithm += Math.log(norm) / n;
            if (logarithm * n < Math.log(GONE)) {
                break;
            }
            double[][] scaled = AbstractIntegrator.linearCombination(1 / norm, power, 0, power);
            power = AbstractIntegrator.product(scaled, scaled);
            n *= 2;
        }
        return Math.exp(logarithm);
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
