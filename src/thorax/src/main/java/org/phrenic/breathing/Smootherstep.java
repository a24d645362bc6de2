package org.phrenic.breathing;

/**
 * Smootherstep: {@code s(u) = u^3 (10 - 15 u + 6 u^2)} on 0 to 1, 0 below and 1 above. Its first and second derivatives
 * are 0 at both ends (K. Perlin 2002, doi 10.1145/566654.566636).
 */
public final class Smootherstep {
    private Smootherstep() {}

    public static double value(double u) {
        if (u <= 0) {
            return 0;
        }
        // For u above 1/2 use 1 - s(1 - u), so that s(1) is exactly 1.
        return u >= 1 ? 1 : u > 0.5 ? 1 - rise(1 - u) : rise(u);
    }

    public static double slope(double u) {
        return u <= 0 || u >= 1 ? 0 : 30 * u * u * (1 - u) * (1 - u);
    }

    /** Integral of the step from 0 to u. */
    static double integral(double u) {
        if (u <= 0) {
            return 0;
        }
        return u >= 1 ? u - 0.5 : u * u * u * u * (2.5 + u * (u - 3));
    }

    private static double rise(double u) {
        return u * u * u * (10 + u * (6 * u - 15));
    }
}
