package org.phrenic.engine.math;

/** Vectors of many numbers, all of one length; sums run in the order of the numbers. */
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
