package org.phrenic.engine.math;

import java.util.Arrays;

/** Values by their place in the order of all. */
public final class OrderStatistic {
    private OrderStatistic() {}

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
