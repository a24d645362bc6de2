package org.phrenic.mesh.query;

/**
 * How distances spread over bins of equal width from 0 to the largest.
 *
 * @param edgesMm bounds of the bins, rising, one more than there are bins
 * @param shares part of the weight in each bin; a distance on a bound counts in the bin above it, the largest in the
 *     last
 */
public record DistanceHistogram(double[] edgesMm, double[] shares) {
    /**
     * @param distances absolute values count
     * @param weights one each, not negative
     * @param bins at least 1
     */
    public static DistanceHistogram of(double[] distances, double[] weights, int bins) {
        double largest = 0;
        double total = 0;
        for (int i = 0; i < distances.length; i++) {
            if (weights[i] > 0) {
                largest = Math.max(largest, Math.abs(distances[i]));
                total += weights[i];
            }
        }
        double[] edges = new double[bins + 1];
        for (int b = 0; b <= bins; b++) {
            edges[b] = largest * b / bins;
        }
        double[] shares = new double[bins];
        for (int i = 0; i < distances.length; i++) {
            if (weights[i] > 0) {
                double place = largest > 0 ? Math.abs(distances[i]) / largest * bins : 0;
                shares[Math.min(bins - 1, (int) place)] += weights[i] / total;
            }
        }
        return new DistanceHistogram(edges, shares);
    }
}
