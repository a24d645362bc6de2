package org.phrenic.study.sweep.index;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.NavigableSet;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * Mean response against one factor, over the runs in which the factor lies in a bin. The other factors vary within each
 * bin as in the whole design.
 *
 * @param at mean of the factor in each bin, ascending
 * @param mean mean response of each bin
 * @param deviation standard deviation of the response in each bin; 0 for one run
 * @param count runs of each bin
 */
public record ResponseCurve(double[] at, double[] mean, double[] deviation, int[] count) {
    /** Most bins of a curve. */
    public static final int MOST_BINS = 8;
    /** Least runs of a bin on average. */
    private static final int LEAST_RUNS = 4;

    /**
     * Computes a curve. A factor with at most {@link #MOST_BINS} different values has one bin a value; another has bins
     * with equally many runs, but for that all runs of one value lie in one bin.
     *
     * @param factor values
     * @param response one per value; those that are not finite are left out
     */
    public static ResponseCurve of(double[] factor, double[] response) {
        List<double[]> pairs = new ArrayList<>();
        for (int i = 0; i < factor.length; i++) {
            if (Double.isFinite(response[i])) {
                pairs.add(new double[] {factor[i], response[i]});
            }
        }
        pairs.sort((a, b) -> Double.compare(a[0], b[0]));
        List<List<double[]>> bins = bins(pairs);
        int n = bins.size();
        ResponseCurve curve = new ResponseCurve(new double[n], new double[n], new double[n], new int[n]);
        for (int b = 0; b < n; b++) {
            curve.fill(b, bins.get(b));
        }
        return curve;
    }

    private static List<List<double[]>> bins(List<double[]> pairs) {
        List<List<double[]>> bins = new ArrayList<>();
        int from = 0;
        for (int end : ends(pairs)) {
            bins.add(pairs.subList(from, end));
            from = end;
        }
        return bins;
    }

    /** Where the bins end, ascending: each at the last run of a value. */
    private static SortedSet<Integer> ends(List<double[]> pairs) {
        NavigableSet<Integer> changes = new TreeSet<>();
        for (int i = 1; i < pairs.size(); i++) {
            if (pairs.get(i)[0] != pairs.get(i - 1)[0]) {
                changes.add(i);
            }
        }
        NavigableSet<Integer> ends = new TreeSet<>(changes);
        if (changes.size() >= MOST_BINS) {
            ends.clear();
            int count = Math.max(2, Math.min(MOST_BINS, pairs.size() / LEAST_RUNS));
            for (int b = 1; b < count; b++) {
                ends.add(nearest(changes, b * pairs.size() / count));
            }
        }
        if (!pairs.isEmpty()) {
            ends.add(pairs.size());
        }
        return ends;
    }

    private static int nearest(NavigableSet<Integer> places, int place) {
        Integer below = places.floor(place);
        Integer above = places.ceiling(place);
        if (below == null || above == null) {
            return below == null ? above : below;
        }
        return place - below < above - place ? below : above;
    }

    private void fill(int bin, List<double[]> pairs) {
        at[bin] = pairs.stream().mapToDouble(p -> p[0]).sum() / pairs.size();
        mean[bin] = pairs.stream().mapToDouble(p -> p[1]).sum() / pairs.size();
        double squares = pairs.stream()
                .mapToDouble(p -> (p[1] - mean[bin]) * (p[1] - mean[bin]))
                .sum();
        deviation[bin] = pairs.size() < 2 ? 0 : Math.sqrt(squares / (pairs.size() - 1));
        count[bin] = pairs.size();
    }

    /** Least and greatest mean over the bins: the bar of the factor in a tornado chart. */
    public double[] extremes() {
        return new double[] {
            Arrays.stream(mean).min().orElse(Double.NaN),
            Arrays.stream(mean).max().orElse(Double.NaN)
        };
    }
}
