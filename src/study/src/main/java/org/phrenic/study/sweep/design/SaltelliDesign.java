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
 * <p>Over few points some dimensions of the sequence are correlated, which falsifies the indices. So the dimensions are
 * taken in their order but for those that have a correlation above {@value #MOST_CORRELATION} with one before, as long
 * as there are others.
 *
 * @param factors number of factors, at most 500
 * @param samples rows of A; a power of 2 keeps the balance of the sequence
 * @param seed of the shift
 */
public record SaltelliDesign(int factors, int samples, long seed) implements SweepDesign {
    private static final double MOST_CORRELATION = 0.05;
    /** Dimensions to choose from, for each that is needed. */
    private static final int CHOICE = 20;

    private static final int MOST_DIMENSIONS = 1000;

    /** Points that belong to a sample: A, B and one for each factor. */
    public static int blockSize(int factors) {
        return factors + 2;
    }

    @Override
    public double[][] points() {
        double[][] columns = columns();
        int block = blockSize(factors);
        double[][] points = new double[Math.multiplyExact(samples, block)][];
        for (int s = 0; s < samples; s++) {
            double[] a = new double[factors];
            double[] b = new double[factors];
            for (int f = 0; f < factors; f++) {
                a[f] = columns[f][s];
                b[f] = columns[factors + f][s];
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

    /** The columns of A, then of B, that is dimensions of the shifted sequence. */
    private double[][] columns() {
        int dimensions = Math.min(MOST_DIMENSIONS, CHOICE * 2 * factors);
        double[][] all = new double[dimensions][samples];
        double[] shift = new SplittableRandom(seed).doubles(dimensions).toArray();
        SobolSequenceGenerator sequence = new SobolSequenceGenerator(dimensions);
        for (int s = 0; s < samples; s++) {
            double[] u = sequence.nextVector();
            for (int d = 0; d < dimensions; d++) {
                all[d][s] = shifted(u[d], shift[d]);
            }
        }
        // Greatest correlation of each dimension with those taken so far; a taken one is out of reach.
        double[] correlations = new double[dimensions];
        double[][] taken = new double[2 * factors][];
        for (int n = 0; n < taken.length; n++) {
            int next = 0;
            for (int d = 1; d < dimensions && correlations[next] > MOST_CORRELATION; d++) {
                next = correlations[d] < Math.max(correlations[next], MOST_CORRELATION) ? d : next;
            }
            taken[n] = all[next];
            for (int d = 0; d < dimensions; d++) {
                double own = Math.abs(correlation(all[d], taken[n]));
                correlations[d] = d == next ? 2 : Math.max(correlations[d], own);
            }
        }
        return taken;
    }

    /** Correlation of two columns whose mean is 1/2 and whose variance is 1/12. */
    private static double correlation(double[] u, double[] v) {
        double sum = 0;
        for (int s = 0; s < u.length; s++) {
            sum += (u[s] - 0.5) * (v[s] - 0.5);
        }
        return 12 * sum / u.length;
    }

    private static double shifted(double u, double by) {
        double sum = u + by;
        return sum < 1 ? sum : sum - 1;
    }
}
