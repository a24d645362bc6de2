package org.phrenic.study.sweep.design;

import java.util.List;
import java.util.SplittableRandom;

/**
 * Trajectories of Morris' elementary effects (Morris 1991, doi 10.1080/00401706.1991.10484804). Each trajectory starts
 * at random levels and moves each factor once, in random order: by half of the levels, up from the lower half and down
 * from the upper half, so that each level is equally frequent. A factor with listed values moves to any other of them;
 * one with a single value stays.
 *
 * @param factors levels of each factor; an even number, but for listed values
 * @param trajectories number of trajectories; each has one point more than there are factors
 * @param seed of the random numbers
 */
public record MorrisDesign(List<FactorLevels> factors, int trajectories, long seed) implements SweepDesign {
    /** @throws IllegalArgumentException if a number of levels is odd */
    public MorrisDesign {
        factors = List.copyOf(factors);
        for (FactorLevels levels : factors) {
            if (!isListed(levels) && levels.count() % 2 != 0) {
                throw new IllegalArgumentException("levels: found " + levels.count() + ", expected an even number");
            }
        }
    }

    private static boolean isListed(FactorLevels levels) {
        return levels.spacing() == FactorLevels.Spacing.LISTED;
    }

    /** Points of a trajectory. */
    public static int blockSize(int factors) {
        return factors + 1;
    }

    @Override
    public double[][] points() {
        SplittableRandom random = new SplittableRandom(seed);
        double[][] points = new double[Math.multiplyExact(trajectories, blockSize(factors.size()))][];
        int next = 0;
        for (int t = 0; t < trajectories; t++) {
            int[] level = new int[factors.size()];
            for (int f = 0; f < level.length; f++) {
                level[f] = random.nextInt(factors.get(f).count());
            }
            int[] order = LatinHypercube.permutation(level.length, random);
            points[next++] = coordinates(level);
            for (int f : order) {
                level[f] = moved(level[f], factors.get(f), random);
                points[next++] = coordinates(level);
            }
        }
        return points;
    }

    private static int moved(int level, FactorLevels levels, SplittableRandom random) {
        int count = levels.count();
        if (!isListed(levels)) {
            return level < count / 2 ? level + count / 2 : level - count / 2;
        }
        return count == 1 ? level : (level + 1 + random.nextInt(count - 1)) % count;
    }

    private double[] coordinates(int[] level) {
        double[] u = new double[level.length];
        for (int f = 0; f < u.length; f++) {
            u[f] = factors.get(f).coordinate(level[f]);
        }
        return u;
    }
}
