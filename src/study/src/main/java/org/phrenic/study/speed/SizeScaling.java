package org.phrenic.study.speed;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.phrenic.study.bare.BareScene;
import org.phrenic.study.bare.BareSettings;
import org.phrenic.study.bare.BareWorkload;

/**
 * What a step of the bare workload costs against the number of nodes.
 *
 * @param rows by size, smallest first
 */
public record SizeScaling(List<Row> rows) {
    /**
     * One size.
     *
     * @param nodes particles
     * @param springs between them
     * @param threads that share the work
     * @param kernel how spring forces are computed
     * @param stepsPerS median of the trials
     */
    public record Row(int nodes, int springs, int threads, String kernel, double stepsPerS) {
        /** What a node costs a step, ns. */
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
     * @param trials of which the median counts
     * @param trialS what a trial takes at least, s
     */
    static Row measure(BareScene scene, int threads, int trials, double trialS) {
        try (BareWorkload work = new BareWorkload(scene, BareSettings.DEFAULT.withThreads(threads))) {
            StepTimer timer = new StepTimer(threads, work::advance);
            int steps = Math.max(3, (int) (trialS * timer.rateOver(trialS)));
            timer.rate(steps);
            double[] rates = new double[trials];
            for (int i = 0; i < trials; i++) {
                rates[i] = timer.rate(steps);
            }
            Arrays.sort(rates);
            return new Row(work.nodeCount(), work.edgeCount(), threads, BareWorkload.KERNEL, rates[trials / 2]);
        }
    }

    /** Exponent b of time = a · nodes^b on one thread, least squares of the logarithms; 1 is linear. */
    public double exponent() {
        SimpleRegression fit = new SimpleRegression();
        rows.stream()
                .filter(row -> row.threads() == 1)
                .forEach(row -> fit.addData(Math.log(row.nodes()), -Math.log(row.stepsPerS())));
        return fit.getSlope();
    }
}
