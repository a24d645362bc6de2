package org.phrenic.study.sweep.design;

/**
 * All combinations of the levels of each factor. The last factor changes fastest.
 *
 * @param levels number of levels of each factor, at least 1
 * @param inner whether the levels of a factor are the middles of equal intervals, as for listed values; otherwise they
 *     are equally spaced and include both ends
 */
public record FullGrid(int[] levels, boolean[] inner) implements SweepDesign {
    @Override
    public double[][] points() {
        long count = 1;
        for (int n : levels) {
            count = Math.multiplyExact(count, n);
        }
        double[][] points = new double[Math.toIntExact(count)][levels.length];
        for (int p = 0; p < points.length; p++) {
            int rest = p;
            for (int f = levels.length - 1; f >= 0; f--) {
                points[p][f] = level(f, rest % levels[f]);
                rest /= levels[f];
            }
        }
        return points;
    }

    private double level(int factor, int number) {
        int n = levels[factor];
        return inner[factor] || n == 1 ? (number + 0.5) / n : (double) number / (n - 1);
    }
}
