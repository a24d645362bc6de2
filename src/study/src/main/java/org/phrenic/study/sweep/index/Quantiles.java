package org.phrenic.study.sweep.index;

import java.util.Arrays;

/** Quantiles by linear interpolation between the sorted values (type 7 of Hyndman and Fan 1996). */
public final class Quantiles {
    private Quantiles() {}

    /** A quantile of ascending values; NaN of none. */
    public static double ofSorted(double[] sorted, double share) {
        if (sorted.length == 0) {
            return Double.NaN;
        }
        double at = share * (sorted.length - 1);
        int below = (int) Math.floor(at);
        int above = Math.min(sorted.length - 1, below + 1);
        return sorted[below] + (at - below) * (sorted[above] - sorted[below]);
    }

    /** Quantiles of values in any order; values that are not finite are ignored. */
    public static double[] of(double[] values, double... shares) {
        double[] sorted =
                Arrays.stream(values).filter(Double::isFinite).sorted().toArray();
        return Arrays.stream(shares).map(share -> ofSorted(sorted, share)).toArray();
    }
}
