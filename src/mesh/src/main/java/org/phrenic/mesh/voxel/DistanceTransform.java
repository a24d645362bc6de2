package org.phrenic.mesh.voxel;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Exact Euclidean distance transform of a box of cells: the distance from each cell's centre to the nearest marked
 * cell's centre (Felzenszwalb and Huttenlocher 2012, doi 10.4086/toc.2012.v008a019). The cells are cubes.
 */
public final class DistanceTransform {
    private static final double FAR = 1e20;

    private DistanceTransform() {}

    /**
     * Computes the distances, in cells. They are about 1e10 if no cell is marked.
     *
     * @param size number of cells along each axis; cell (i, j, k) has the index {@code i + size[0] (j + size[1] k)}
     */
    public static float[] of(boolean[] marked, int[] size) {
        if (marked.length != size[0] * size[1] * size[2]) {
            throw new IllegalArgumentException(
                    marked.length + " cells in a box of " + Arrays.toString(size) + ", expected as many");
        }
        float[] squares = new float[marked.length];
        for (int cell = 0; cell < marked.length; cell++) {
            squares[cell] = (float) (marked[cell] ? 0 : FAR);
        }
        for (int axis = 0; axis < 3; axis++) {
            int length = size[axis];
            int stride = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
            IntStream.range(0, squares.length / length)
                    .parallel()
                    .forEach(line ->
                            transform(squares, line / stride * stride * length + line % stride, stride, length));
        }
        for (int cell = 0; cell < squares.length; cell++) {
            squares[cell] = (float) Math.sqrt(squares[cell]);
        }
        return squares;
    }

    /**
     * Computes signed distances, in cells: outside the distance to the nearest cell inside, inside minus the distance
     * to the nearest cell outside.
     *
     * @param size as for {@link #of}
     */
    public static float[] signed(boolean[] inside, int[] size) {
        boolean[] outside = new boolean[inside.length];
        for (int cell = 0; cell < inside.length; cell++) {
            outside[cell] = !inside[cell];
        }
        float[] distance = of(inside, size);
        float[] depth = of(outside, size);
        for (int cell = 0; cell < distance.length; cell++) {
            distance[cell] -= depth[cell];
        }
        return distance;
    }

    /** Lower envelope of the parabolas {@code (x - q)^2 + f(q)} along one line. */
    private static void transform(float[] squares, int start, int stride, int length) {
        double[] f = new double[length];
        for (int q = 0; q < length; q++) {
            f[q] = squares[start + q * stride];
        }
        int[] vertex = new int[length];
        double[] from = new double[length + 1];
        int last = 0;
        from[0] = Double.NEGATIVE_INFINITY;
        from[1] = Double.POSITIVE_INFINITY;
        for (int q = 1; q < length; q++) {
            double crossing = crossing(f, q, vertex[last]);
            while (crossing <= from[last]) {
                last--;
                crossing = crossing(f, q, vertex[last]);
            }
            vertex[++last] = q;
            from[last] = crossing;
            from[last + 1] = Double.POSITIVE_INFINITY;
        }
        int at = 0;
        for (int q = 0; q < length; q++) {
            while (from[at + 1] < q) {
                at++;
            }
            int v = vertex[at];
            squares[start + q * stride] = (float) ((q - v) * (double) (q - v) + f[v]);
        }
    }

    private static double crossing(double[] f, int q, int v) {
        return (f[q] + (double) q * q - (f[v] + (double) v * v)) / (2.0 * (q - v));
    }
}
