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

    /** Distances between points a and b of an array with three numbers per point. */
    public static double[] distances(double[] points, int[] a, int[] b) {
        double[] distances = new double[a.length];
        for (int i = 0; i < distances.length; i++) {
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = points[3 * b[i] + axis] - points[3 * a[i] + axis];
                squared += d * d;
            }
            distances[i] = Math.sqrt(squared);
        }
        return distances;
    }
}
