package org.phrenic.study.sweep.design;

import java.util.SplittableRandom;

/**
 * Trajectories of Morris' elementary effects (Morris 1991, doi 10.1080/00401706.1991.10484804). Each trajectory starts
 * at a random point of a regular grid of {@code levels} levels and moves each factor once, in random order, by
 * {@link #step}: up from the lower half of the levels, down from the upper half.
 *
 * @param factors number of factors
 * @param trajectories number of trajectories; each has one point more than there are factors
 * @param levels even number of levels of each factor
 * @param seed of the random numbers
 */
public record MorrisDesign(int factors, int trajectories, int levels, long seed) implements SweepDesign {
    /** @throws IllegalArgumentException if the number of levels is odd */
    public MorrisDesign {
        if (levels < 2 || levels % 2 != 0) {
            throw new IllegalArgumentException("levels: found " + levels + ", expected an even number from 2");
        }
    }

    /** Change of a factor along a trajectory: p / (2 (p - 1)) for p levels. */
    public double step() {
        return levels / (2.0 * (levels - 1));
    }

    /** Points of a trajectory. */
    public static int blockSize(int factors) {
        return factors + 1;
    }

    @Override
    public double[][] points() {
        SplittableRandom random = new SplittableRandom(seed);
        double[][] points = new double[Math.multiplyExact(trajectories, blockSize(factors))][];
        int next = 0;
        for (int t = 0; t < trajectories; t++) {
            int[] level = random.ints(factors, 0, levels).toArray();
            int[] order = LatinHypercube.permutation(factors, random);
            points[next++] = coordinates(level);
            for (int factor : order) {
                level[factor] += level[factor] < levels / 2 ? levels / 2 : -levels / 2;
                points[next++] = coordinates(level);
            }
        }
        return points;
    }

    private double[] coordinates(int[] level) {
        double[] u = new double[factors];
        for (int f = 0; f < factors; f++) {
            u[f] = (double) level[f] / (levels - 1);
        }
        return u;
    }
}
