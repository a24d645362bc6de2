package org.phrenic.study.sweep.design;

import java.util.List;

/**
 * All combinations of the levels of each factor. The last factor changes fastest.
 *
 * @param factors levels of each factor
 */
public record FullGrid(List<FactorLevels> factors) implements SweepDesign {
    public FullGrid {
        factors = List.copyOf(factors);
    }

    @Override
    public double[][] points() {
        long count = 1;
        for (FactorLevels levels : factors) {
            count = Math.multiplyExact(count, levels.count());
        }
        double[][] points = new double[Math.toIntExact(count)][factors.size()];
        for (int p = 0; p < points.length; p++) {
            int rest = p;
            for (int f = factors.size() - 1; f >= 0; f--) {
                FactorLevels levels = factors.get(f);
                points[p][f] = levels.coordinate(rest % levels.count());
                rest /= levels.count();
            }
        }
        return points;
    }
}
