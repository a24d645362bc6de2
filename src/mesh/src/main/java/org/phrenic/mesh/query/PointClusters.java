package org.phrenic.mesh.query;

import java.util.Arrays;
import java.util.Comparator;

/**
 * Points in clusters of neighbours, by halving along the longest side of their box down to a number of points. The
 * first point of a cluster is the one nearest to its mean. Not affected by later motion of the points.
 */
public final class PointClusters {
    static final int MOST = 24;

    private final int most;
    private final Integer[] sorted;
    private final int[] order;
    private int[] starts = new int[1];
    private int count;

    /** Clusters of at most {@value #MOST} points, three numbers each. */
    public PointClusters(double[] points) {
        this(points, MOST);
    }

    /**
     * @param points three numbers each
     * @param most greatest number of points in a cluster
     */
    public PointClusters(double[] points, int most) {
        this.most = most;
        sorted = new Integer[points.length / 3];
        Arrays.setAll(sorted, i -> i);
        split(points, 0, sorted.length);
        order = Arrays.stream(sorted).mapToInt(i -> i).toArray();
    }

    private void split(double[] points, int from, int to) {
        if (to - from <= most) {
            if (to > from) {
                add(points, from, to);
            }
            return;
        }
        int axis = longestAxis(points, from, to);
        Arrays.sort(
                sorted,
                from,
                to,
                Comparator.<Integer>comparingDouble(i -> points[3 * i + axis]).thenComparing(i -> i));
        int middle = (from + to) >>> 1;
        split(points, from, middle);
        split(points, middle, to);
    }

    private int longestAxis(double[] points, int from, int to) {
        int longest = 0;
        double length = -1;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                low = Math.min(low, points[3 * sorted[i] + axis]);
                high = Math.max(high, points[3 * sorted[i] + axis]);
            }
            if (high - low > length) {
                length = high - low;
                longest = axis;
            }
        }
        return longest;
    }

    private void add(double[] points, int from, int to) {
        double[] mean = new double[3];
        for (int i = from; i < to; i++) {
            for (int axis = 0; axis < 3; axis++) {
                mean[axis] += points[3 * sorted[i] + axis] / (to - from);
            }
        }
        int first = from;
        for (int i = from; i < to; i++) {
            if (squaredDistance(points, sorted[i], mean) < squaredDistance(points, sorted[first], mean)) {
                first = i;
            }
        }
        Integer swap = sorted[from];
        sorted[from] = sorted[first];
        sorted[first] = swap;
        starts = Arrays.copyOf(starts, count + 2);
        starts[++count] = to;
    }

    private static double squaredDistance(double[] points, int i, double[] from) {
        double dx = points[3 * i] - from[0];
        double dy = points[3 * i + 1] - from[1];
        double dz = points[3 * i + 2] - from[2];
        return dx * dx + dy * dy + dz * dz;
    }

    public int count() {
        return count;
    }

    /** Place of the first point of a cluster in {@link #order}; that of the cluster after the last is the end. */
    public int start(int cluster) {
        return starts[cluster];
    }

    /** Point indices, cluster by cluster. */
    public int[] order() {
        return order;
    }
}
