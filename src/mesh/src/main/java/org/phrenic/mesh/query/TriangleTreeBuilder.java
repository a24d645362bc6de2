package org.phrenic.mesh.query;

import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;

/**
 * Halves the triangles of a mesh at the median centroid, depth first; leaves at most {@code leaf} triangles together.
 */
final class TriangleTreeBuilder {
    private final double[] centroids;
    private final int[] order;
    private final int[] child;
    private final int[] count;
    private final int leaf;
    private int nodes;

    TriangleTreeBuilder(TriangleMesh mesh, int leaf) {
        this.leaf = leaf;
        int n = mesh.triangleCount();
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        centroids = new double[3 * n];
        order = new int[n];
        for (int i = 0; i < n; i++) {
            order[i] = i;
            int a = 3 * t[3 * i];
            int b = 3 * t[3 * i + 1];
            int c = 3 * t[3 * i + 2];
            for (int k = 0; k < 3; k++) {
                centroids[3 * i + k] = p[a + k] + p[b + k] + p[c + k];
            }
        }
        // Halving down to the leaf size makes leaves of more than leaf / 2 triangles.
        int most = Math.max(1, 4 * n / Math.max(1, leaf) + 2);
        child = new int[most];
        count = new int[most];
        if (n > 0) {
            build(0, n);
        }
    }

    int[] order() {
        return order;
    }

    int[] child() {
        return Arrays.copyOf(child, nodes);
    }

    int[] count() {
        return Arrays.copyOf(count, nodes);
    }

    int nodes() {
        return nodes;
    }

    private void build(int from, int to) {
        int node = nodes++;
        count[node] = to - from;
        if (to - from <= leaf) {
            child[node] = -1 - from;
            return;
        }
        int middle = (from + to) >>> 1;
        select(from, to - 1, middle, longestAxis(from, to));
        build(from, middle);
        child[node] = nodes;
        build(middle, to);
    }

    private int longestAxis(int from, int to) {
        int longest = 0;
        double extent = -1;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                double value = centroids[3 * order[i] + axis];
                low = value < low ? value : low;
                high = value > high ? value : high;
            }
            if (high - low > extent) {
                extent = high - low;
                longest = axis;
            }
        }
        return longest;
    }

    /** Hoare's selection: afterwards no centroid before {@code k} lies beyond one from {@code k} on. */
    private void select(int first, int last, int k, int axis) {
        int from = first;
        int to = last;
        while (from < to) {
            double pivot = medianOfThree(from, (from + to) >>> 1, to, axis);
            int i = from;
            int j = to;
            while (i <= j) {
                while (centroids[3 * order[i] + axis] < pivot) {
                    i++;
                }
                while (centroids[3 * order[j] + axis] > pivot) {
                    j--;
                }
                if (i <= j) {
                    int swap = order[i];
                    order[i] = order[j];
                    order[j] = swap;
                    i++;
                    j--;
                }
            }
            if (k <= j) {
                to = j;
            } else if (k >= i) {
                from = i;
            } else {
                return;
            }
        }
    }

    private double medianOfThree(int i, int j, int k, int axis) {
        double a = centroids[3 * order[i] + axis];
        double b = centroids[3 * order[j] + axis];
        double c = centroids[3 * order[k] + axis];
        return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
    }
}
