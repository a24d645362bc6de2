package org.phrenic.engine.constraint;

import org.phrenic.engine.ParticleSystem;

/**
 * The paper's projection for links of which no two share a node, in batches: differences are gathered, roots and quotients done in plain loops (which become vector instructions),
 * shifts given back. Each short loop waits for memory many links at a time; done link by link, each would wait for its own.
 */
final class DisjointLinks {
    /** Links a batch at most. */
    static final int SIZE = 256;

    private final double[] dx = new double[SIZE];
    private final double[] dy = new double[SIZE];
    private final double[] dz = new double[SIZE];
    private final double[] inverseMass = new double[SIZE];
    private final double[] otherInverseMass = new double[SIZE];
    private final double[] shift = new double[SIZE];

    /**
     * Brings the links {@code [from, to)} to their lengths, half to each end for equal masses, and gives velocities the same shift over h.
     *
     * @param a first node of each link times 3
     * @param b other node of each times 3
     * @param length mm
     */
    void project(ParticleSystem system, double h, int[] a, int[] b, double[] length, int from, int to) {
        int n = to - from;
        double[] x = system.positions();
        differences(x, system.inverseMasses(), a, b, from, n);
        for (int i = 0; i < n; i++) {
            shift[i] = Math.sqrt(dx[i] * dx[i] + dy[i] * dy[i] + dz[i] * dz[i]);
        }
        for (int i = 0; i < n; i++) {
            shift[i] = (shift[i] - length[from + i]) / (shift[i] * (inverseMass[i] + otherInverseMass[i]));
        }
        for (int i = 0; i < n; i++) {
            // Both ends given, or on one spot, where the line has no direction.
            if (!(Math.abs(shift[i]) <= Double.MAX_VALUE)) {
                shift[i] = 0;
            }
        }
        for (int i = 0; i < n; i++) {
            inverseMass[i] *= shift[i];
            otherInverseMass[i] *= shift[i];
        }
        give(x, a, b, from, n);
        double perStep = 1 / h;
        for (int i = 0; i < n; i++) {
            inverseMass[i] *= perStep;
            otherInverseMass[i] *= perStep;
        }
        give(system.velocities(), a, b, from, n);
    }

    private void differences(double[] x, double[] w, int[] a, int[] b, int from, int n) {
        for (int i = 0; i < n; i++) {
            int p = a[from + i];
            int q = b[from + i];
            dx[i] = x[q] - x[p];
            dy[i] = x[q + 1] - x[p + 1];
            dz[i] = x[q + 2] - x[p + 2];
            inverseMass[i] = w[p / 3];
            otherInverseMass[i] = w[q / 3];
        }
    }

    /** Adds to u of both ends what the masses and the shift make of the difference. */
    private void give(double[] u, int[] a, int[] b, int from, int n) {
        for (int i = 0; i < n; i++) {
            int p = a[from + i];
            int q = b[from + i];
            double sa = inverseMass[i];
            double sb = otherInverseMass[i];
            u[p] += sa * dx[i];
            u[p + 1] += sa * dy[i];
            u[p + 2] += sa * dz[i];
            u[q] -= sb * dx[i];
            u[q + 1] -= sb * dy[i];
            u[q + 2] -= sb * dz[i];
        }
    }
}
