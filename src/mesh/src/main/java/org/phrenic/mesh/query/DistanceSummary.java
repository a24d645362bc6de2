package org.phrenic.mesh.query;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.engine.math.ArgSort;

/**
 * Weighted statistics of distances, mm. A quantile is the smallest distance up to which that share of the weight lies.
 *
 * @param points distances with a weight above 0
 * @param mean weighted mean
 * @param deviation standard deviation about the mean, of the population
 * @param rms root of the mean square
 * @param median half of the weight lies at or below it
 * @param percentile95 95 % of the weight lie at or below it
 * @param maximum largest distance
 */
public record DistanceSummary(
        int points, double mean, double deviation, double rms, double median, double percentile95, double maximum) {
    private static final double MOST = 0.95;

    /** All figures 0: of no distances. */
    public static final DistanceSummary NONE = new DistanceSummary(0, 0, 0, 0, 0, 0, 0);

    /**
     * Statistics of absolute distances.
     *
     * @param weights one each, not negative; those of weight 0 do not count
     * @throws IllegalArgumentException if there are not as many weights as distances
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
                quantile(d, w, total, MOST),
                d[d.length - 1]);
    }

    /** As {@link #of(double[], double[])}, every distance with the same weight. */
    public static DistanceSummary of(double[] distances) {
        double[] weights = new double[distances.length];
        Arrays.fill(weights, 1);
        return of(distances, weights);
    }

    /** Sizes of the distances that have a weight, rising, and their weights. */
    private static double[][] sorted(double[] distances, double[] weights) {
        int[] kept =
                IntStream.range(0, distances.length).filter(i -> weights[i] > 0).toArray();
        // The bits of a non-negative number sort as the number does.
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
