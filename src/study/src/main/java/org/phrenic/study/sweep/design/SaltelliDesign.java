package org.phrenic.study.sweep.design;

import java.util.SplittableRandom;
import org.apache.commons.math3.random.SobolSequenceGenerator;

/**
 * Saltelli's sampling for variance-based sensitivity indices (Saltelli et al. 2010, doi 10.1016/j.cpc.2009.09.018). Two
 * independent matrices A and B of {@code samples} rows come from one Sobol' sequence in twice as many dimensions.
 * Matrix AB<sub>i</sub> is A with column i of B. The rows are in the order A, B, AB<sub>1</sub> ... AB<sub>k</sub> of
 * the first sample, then of the second, so that the first blocks of an unfinished study are complete.
 *
 * <p>The sequence is shifted by a seeded random vector modulo 1 (Cranley and Patterson 1976), which keeps its
 * uniformity and its first point away from the corner of the cube.
 *
 * @param factors number of factors, at most 500
 * @param samples rows of A; a power of 2 keeps the balance of the sequence
 * @param seed of the shift
 */
public record SaltelliDesign(int factors, int samples, long seed) implements SweepDesign {
    /** Largest number of factors: the sequence has 1000 dimensions. */
    public static final int MAX_FACTORS = 500;

    /** Points that belong to a sample: A, B and one for each factor. */
    public static int blockSize(int factors) {
        return factors + 2;
    }

    @Override
    public double[][] points() {
        SobolSequenceGenerator sequence = new SobolSequenceGenerator(2 * factors);
        SplittableRandom random = new SplittableRandom(seed);
        double[] shift = random.doubles(2L * factors).toArray();
        int block = blockSize(factors);
        double[][] points = new double[Math.multiplyExact(samples, block)][];
        for (int s = 0; s < samples; s++) {
            double[] both = sequence.nextVector();
            double[] a = new double[factors];
            double[] b = new double[factors];
            for (int f = 0; f < factors; f++) {
                a[f] = shifted(both[f], shift[f]);
                b[f] = shifted(both[factors + f], shift[factors + f]);
            }
            points[s * block] = a;
            points[s * block + 1] = b;
            for (int f = 0; f < factors; f++) {
                double[] mixed = a.clone();
                mixed[f] = b[f];
                points[s * block + 2 + f] = mixed;
            }
        }
        return points;
    }

    private static double shifted(double u, double by) {
        double sum = u + by;
        return sum < 1 ? sum : sum - 1;
    }
}
