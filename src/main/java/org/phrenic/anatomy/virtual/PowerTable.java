package org.phrenic.anatomy.virtual;

/**
 * The two powers that a superellipse asks for at each of the million points where the chest wall is sampled, from a table: {@code m^n} and {@code (1 + m^n)^(-1/n)} for m from 0 to 1. Bilinear between entries; off by at
 * most 6e-6, a micrometre of the wall.
 */
final class PowerTable {
    private static final int RATIOS = 512;
    private static final int EXPONENTS = 32;

    private final double least;
    private final double step;
    private final double[] power = new double[(RATIOS + 1) * (EXPONENTS + 1)];
    private final double[] root = new double[power.length];

    /**
     * @param least exponent n, more than 1
     * @param most exponent n
     */
    PowerTable(double least, double most) {
        this.least = least;
        step = Math.max(most - least, 1e-9) / EXPONENTS;
        for (int e = 0; e <= EXPONENTS; e++) {
            double n = least + e * step;
            for (int r = 0; r <= RATIOS; r++) {
                double p = StrictMath.pow(r / (double) RATIOS, n);
                power[e * (RATIOS + 1) + r] = p;
                root[e * (RATIOS + 1) + r] = StrictMath.pow(1 + p, -1 / n);
            }
        }
    }

    /** {@code ratio^n}. */
    double power(double ratio, double n) {
        return at(power, ratio, n);
    }

    /** {@code (1 + ratio^n)^(-1/n)}. */
    double root(double ratio, double n) {
        return at(root, ratio, n);
    }

    private double at(double[] table, double ratio, double n) {
        double r = ratio * RATIOS;
        double e = (n - least) / step;
        int column = Math.max(0, Math.min(RATIOS - 1, (int) r));
        int row = Math.max(0, Math.min(EXPONENTS - 1, (int) e));
        double s = r - column;
        double t = e - row;
        int i = row * (RATIOS + 1) + column;
        int j = i + RATIOS + 1;
        return (1 - t) * (table[i] + s * (table[i + 1] - table[i])) + t * (table[j] + s * (table[j + 1] - table[j]));
    }
}
