package org.phrenic.mesh.query;

/**
 * Weighted histogram of absolute distances with bins of equal width from 0 to the maximum.
 *
 * @param edgesMm bin edges, mm, ascending; one more than there are bins
 * @param shares fraction of the weight in each bin; a distance on an edge belongs to the bin above, the maximum to the
 *     last bin
 */
public record DistanceHistogram(double[] edgesMm, double[] shares) {
    /**
     * @param distances distances, mm; their absolute values are used
     * @param weights one per distance, not negative
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
