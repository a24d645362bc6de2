package org.phrenic.engine.math;

/**
 * What conjugate gradients and Lanczos' method are made of: sums over vectors of many numbers, all of one length, in
 * short loops and in the order of the numbers.
 */
public final class DenseVectors {
    private DenseVectors() {}

    public static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    /** to + share what, in place. */
    public static void addScaled(double[] to, double share, double[] what) {
        for (int i = 0; i < to.length; i++) {
            to[i] += share * what[i];
        }
    }

    /** The next direction of conjugate gradients: fresh + keep direction, in place. */
    public static void scaleAndAdd(double[] direction, double keep, double[] fresh) {
        for (int i = 0; i < direction.length; i++) {
            direction[i] = fresh[i] + keep * direction[i];
        }
    }
}
