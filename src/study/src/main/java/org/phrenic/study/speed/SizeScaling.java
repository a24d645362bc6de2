package org.phrenic.study.speed;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.phrenic.study.bare.BareScene;
import org.phrenic.study.bare.BareSettings;
import org.phrenic.study.bare.BareWorkload;

/**
 * Cost of a step of the bare workload against the number of nodes.
 *
 * @param rows by size, smallest first
 */
public record SizeScaling(List<Row> rows) {
    /**
     * Measurement of one size.
     *
     * @param nodes number of particles
     * @param springs number of springs
     * @param threads number of worker threads
     * @param kernel label of the spring force kernel
     * @param stepsPerS median of the trials, steps/s
     */
    public record Row(int nodes, int springs, int threads, String kernel, double stepsPerS) {
        /** Time per node and step, ns. */
        public double nanosPerNodeStep() {
            return 1e9 / stepsPerS / nodes;
        }
    }

    public SizeScaling {
        rows = List.copyOf(rows);
    }

    /**
     * Measures one size.
     *
     * @param trials number of trials; their median is used
     * @param trialS minimum duration of a trial, s
     */
    static Row measure(BareScene scene, int threads, int trials, double trialS) {
        try (BareWorkload work = new BareWorkload(scene, BareSettings.DEFAULT.withThreads(threads))) {
            StepTimer timer = new StepTimer(threads, work::advance);
            int steps = Math.max(3, (int) (trialS * timer.rateOver(trialS)));
            timer.rate(steps);
            double[] rates = new double[trials];
            Arrays.setAll(rates, i -> timer.rate(steps));
            Arrays.sort(rates);
            return new Row(work.nodeCount(), work.edgeCount(), threads, BareWorkload.KERNEL, rates[trials / 2]);
        }
    }

    /** Exponent b of time = a · nodes^b on one thread, by least squares of the logarithms; 1 is linear scaling. */
    public double exponent() {
        SimpleRegression fit = new SimpleRegression();
        rows.stream()
                .filter(row -> row.threads() == 1)
                .forEach(row -> fit.addData(StrictMath.log(row.nodes()), -StrictMath.log(row.stepsPerS())));
        return fit.getSlope();
    }
}
