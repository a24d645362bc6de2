package org.phrenic.mesh.query;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.IntStream;
import org.phrenic.engine.math.ArgSort;

/**
 * Weighted statistics of distances, mm. The p-quantile is the smallest distance whose cumulative weight reaches p.
 *
 * @param points number of distances with a weight above 0
 * @param mean weighted mean
 * @param deviation population standard deviation
 * @param rms root mean square
 * @param median 50 % quantile
 * @param percentile95 95 % quantile
 * @param maximum largest distance
 */
public record DistanceSummary(
        int points, double mean, double deviation, double rms, double median, double percentile95, double maximum) {

    /** Summary of no distances: all values are 0. */
    public static final DistanceSummary NONE = new DistanceSummary(0, 0, 0, 0, 0, 0, 0);

    /**
     * Statistics of absolute distances.
     *
     * @param weights one per distance, not negative; distances with weight 0 are ignored
     * @throws IllegalArgumentException if the numbers of weights and distances differ
     */
    public static DistanceSummary of(double[] distances, double[] weights) {
        if (distances.length != weights.length) {
            throw new IllegalArgumentException(
                    distances.length + " distances and " + weights.length + " weights, expected as many");
        }
        double[][] sorted = sorted(distances, weights);
        double[] d = sorted[0];
        double[] w = sorted[1];
        if (d.length == 0) {
            return NONE;
        }
        double total = 0;
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < d.length; i++) {
            total += w[i];
            sum += w[i] * d[i];
            squares += w[i] * d[i] * d[i];
        }
        double mean = sum / total;
        double spread = 0;
        for (int i = 0; i < d.length; i++) {
            spread += w[i] * (d[i] - mean) * (d[i] - mean);
        }
        return new DistanceSummary(
                d.length,
                mean,
                Math.sqrt(spread / total),
                Math.sqrt(squares / total),
                quantile(d, w, total, 0.5),
                quantile(d, w, total, 0.95),
                d[d.length - 1]);
    }

    /** Statistics of absolute distances with equal weights. */
    public static DistanceSummary of(double[] distances) {
        double[] weights = new double[distances.length];
        Arrays.fill(weights, 1);
        return of(distances, weights);
    }

    /** The statistics by their keys in files, mm, in the order of a table. */
    public Map<String, Double> values() {
        Map<String, Double> values = new LinkedHashMap<>();
        values.put("mean_mm", mean);
        values.put("sd_mm", deviation);
        values.put("rms_mm", rms);
        values.put("median_mm", median);
        values.put("percentile_95_mm", percentile95);
        values.put("maximum_mm", maximum);
        return values;
    }

    /** Absolute distances with a positive weight, ascending, and their weights. */
    private static double[][] sorted(double[] distances, double[] weights) {
        int[] kept =
                IntStream.range(0, distances.length).filter(i -> weights[i] > 0).toArray();
        // The bits of a non-negative number sort like its value.
        int[] order = ArgSort.of(IntStream.of(kept)
                .mapToLong(i -> Double.doubleToRawLongBits(Math.abs(distances[i])))
                .toArray());
        double[][] sorted = new double[2][kept.length];
        for (int k = 0; k < kept.length; k++) {
            sorted[0][k] = Math.abs(distances[kept[order[k]]]);
            sorted[1][k] = weights[kept[order[k]]];
        }
        return sorted;
    }

    private static double quantile(double[] distances, double[] weights, double total, double share) {
        double below = 0;
        for (int i = 0; i < distances.length; i++) {
            below += weights[i];
            if (below >= share * total) {
                return distances[i];
            }
        }
        return distances[distances.length - 1];
    }
}
