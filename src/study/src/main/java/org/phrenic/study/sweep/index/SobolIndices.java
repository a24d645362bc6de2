package org.phrenic.study.sweep.index;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.study.sweep.design.SaltelliDesign;

/**
 * Variance-based sensitivity of a response Y to independent factors X<sub>i</sub>. With f<sub>A</sub>, f<sub>B</sub>
 * and f<sub>ABi</sub> the responses to the matrices of a {@link SaltelliDesign} and V the variance of f<sub>A</sub> and
 * f<sub>B</sub> together:
 *
 * <pre>
 *   first order  S_i  = V(E(Y | X_i)) / V        estimated by mean(f_B (f_ABi - f_A)) / V
 *   total        ST_i = E(V(Y | X_~i)) / V       estimated by mean((f_A - f_ABi)^2) / (2 V)
 * </pre>
 *
 * The first estimator is that of Saltelli et al. 2010 (doi 10.1016/j.cpc.2009.09.018, table 2 b), the second that of
 * Jansen 1999 (doi 10.1016/S0010-4655(98)00154-4). f<sub>B</sub> is taken relative to the mean, which changes no
 * expectation and lowers the scatter.
 *
 * @param first S of each factor
 * @param total ST of each factor
 * @param samples complete samples that were used
 * @param left samples left out because a run of them failed or is missing
 */
public record SobolIndices(List<Estimate> first, List<Estimate> total, int samples, int left) {
    /**
     * Computes the indices.
     *
     * @param responses in the order of the design; NaN for a run that failed or is missing
     */
    public static SobolIndices of(double[] responses, int factors, Bootstrap bootstrap) {
        int block = SaltelliDesign.blockSize(factors);
        List<double[]> rows = CompleteBlocks.of(responses, block);
        List<Estimate> first = new ArrayList<>();
        List<Estimate> total = new ArrayList<>();
        for (int f = 0; f < factors; f++) {
            int mixed = 2 + f;
            first.add(bootstrap.of(rows.size(), chosen -> first(rows, chosen, mixed)));
            total.add(bootstrap.of(rows.size(), chosen -> total(rows, chosen, mixed)));
        }
        return new SobolIndices(first, total, rows.size(), responses.length / block - rows.size());
    }

    private static double first(List<double[]> rows, int[] chosen, int mixed) {
        double mean = mean(rows, chosen);
        double sum = 0;
        for (int i : chosen) {
            double[] f = rows.get(i);
            sum += (f[1] - mean) * (f[mixed] - f[0]);
        }
        return sum / chosen.length / variance(rows, chosen, mean);
    }

    private static double total(List<double[]> rows, int[] chosen, int mixed) {
        double sum = 0;
        for (int i : chosen) {
            double[] f = rows.get(i);
            sum += (f[0] - f[mixed]) * (f[0] - f[mixed]);
        }
        return sum / (2.0 * chosen.length) / variance(rows, chosen, mean(rows, chosen));
    }

    private static double mean(List<double[]> rows, int[] chosen) {
        double sum = 0;
        for (int i : chosen) {
            sum += rows.get(i)[0] + rows.get(i)[1];
        }
        return sum / (2.0 * chosen.length);
    }

    private static double variance(List<double[]> rows, int[] chosen, double mean) {
        double sum = 0;
        for (int i : chosen) {
            double a = rows.get(i)[0] - mean;
            double b = rows.get(i)[1] - mean;
            sum += a * a + b * b;
        }
        return sum / (2.0 * chosen.length);
    }
}
