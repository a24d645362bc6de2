package org.phrenic.study.sweep.design;

import java.util.SplittableRandom;

/**
 * Latin hypercube sampling (McKay, Beckman and Conover 1979, doi 10.1080/00401706.1979.10489755): each factor has
 * exactly one point in each of {@code samples} equal intervals, at a random place in it.
 *
 * @param factors number of factors
 * @param samples number of points
 * @param seed of the random numbers
 */
public record LatinHypercube(int factors, int samples, long seed) implements SweepDesign {
    @Override
    public double[][] points() {
        SplittableRandom random = new SplittableRandom(seed);
        double[][] points = new double[samples][factors];
        for (int f = 0; f < factors; f++) {
            int[] order = permutation(samples, random);
            for (int p = 0; p < samples; p++) {
                points[p][f] = (order[p] + random.nextDouble()) / samples;
            }
        }
        return points;
    }

    /** The numbers 0 to {@code n} - 1 in random order (Fisher and Yates). */
    static int[] permutation(int n, SplittableRandom random) {
        int[] order = new int[n];
        for (int i = 0; i < n; i++) {
            int j = random.nextInt(i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        return order;
    }
}
