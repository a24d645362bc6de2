package org.phrenic.engine.math;

/** Operations on dense vectors of equal length; sums run in index order. */
public final class DenseVectors {
    private DenseVectors() {}

    public static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    /** {@code to += scale * other}. */
    public static void addScaled(double[] to, double scale, double[] other) {
        for (int i = 0; i < to.length; i++) {
            to[i] += scale * other[i];
        }
    }
}
