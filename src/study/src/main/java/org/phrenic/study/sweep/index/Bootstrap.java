package org.phrenic.study.sweep.index;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;

/**
 * Confidence intervals by bootstrap: a statistic is evaluated for samples drawn with replacement, and the interval is
 * between the 2.5 % and the 97.5 % quantile of its values (Efron 1979, doi 10.1214/aos/1176344552). The same seed gives
 * the same interval.
 *
 * @param replicates number of drawn samples
 * @param seed of the random numbers
 */
public record Bootstrap(int replicates, long seed) {
    /** 1000 replicates. */
    public static final Bootstrap USUAL = new Bootstrap(1000, 1);

    private static final double TAIL = 0.025;
    /** Fewer samples have no interval. */
    private static final int LEAST_SAMPLES = 3;

    /**
     * Evaluates a statistic.
     *
     * @param count number of samples
     * @param statistic of samples that are given by their numbers
     */
    public Estimate of(int count, ToDoubleFunction<int[]> statistic) {
        int[] chosen = new int[count];
        Arrays.setAll(chosen, i -> i);
        double value = count == 0 ? Double.NaN : statistic.applyAsDouble(chosen);
        if (count < LEAST_SAMPLES) {
            return new Estimate(value, Double.NaN, Double.NaN);
        }
        SplittableRandom random = new SplittableRandom(seed);
        double[] values = new double[replicates];
        for (int r = 0; r < replicates; r++) {
            for (int i = 0; i < count; i++) {
                chosen[i] = random.nextInt(count);
            }
            values[r] = statistic.applyAsDouble(chosen);
        }
        values = Arrays.stream(values).filter(Double::isFinite).sorted().toArray();
        return new Estimate(value, Quantiles.ofSorted(values, TAIL), Quantiles.ofSorted(values, 1 - TAIL));
    }
}
