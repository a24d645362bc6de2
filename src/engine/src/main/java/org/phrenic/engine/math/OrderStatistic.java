package org.phrenic.engine.math;

import java.util.Arrays;

/** Values by their place in the order of all. */
public final class OrderStatistic {
    private OrderStatistic() {}

    /**
     * The median of values: of an even number of them, the mean of the middle two.
     *
     * @return NaN without values
     */
    public static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int n = sorted.length;
        return n == 0 ? Double.NaN : 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
    }

    /**
     * One of the values: that which the given share of them does not exceed, without interpolation.
     *
     * @param share 0 for the least to 1 for the greatest
     * @return 0 without values
     */
    public static double atShare(double[] values, double share) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted.length == 0 ? 0 : sorted[(int) (share * (sorted.length - 1))];
    }
}
