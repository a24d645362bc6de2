package org.phrenic.study.speed;

import java.util.List;

/**
 * What a step costs against the number of nodes.
 *
 * @param rows by size, smallest first
 */
public record SizeScaling(List<Row> rows) {
    /**
     * One size.
     *
     * @param nodes particles
     * @param edges springs
     * @param threads that shared the work
     * @param kernel how spring forces were computed
     * @param stepsPerSecond median of the trials
     */
    public record Row(int nodes, int edges, int threads, String kernel, double stepsPerSecond) {
        /** What a node costs a step, ns. */
        public double nanosPerNodeStep() {
            return 1e9 / stepsPerSecond / nodes;
        }
    }

    public SizeScaling {
        rows = List.copyOf(rows);
    }

    /** Exponent b of time = a · nodes^b on one thread, least squares of the logarithms; 1 is linear. */
    public double exponent() {
        List<Row> one = rows.stream().filter(row -> row.threads() == 1).toList();
        double meanX =
                one.stream().mapToDouble(r -> Math.log(r.nodes())).average().orElse(0);
        double meanY = one.stream()
                .mapToDouble(r -> -Math.log(r.stepsPerSecond()))
                .average()
                .orElse(0);
        double xy = 0;
        double xx = 0;
        for (Row r : one) {
            double x = Math.log(r.nodes()) - meanX;
            xy += x * (-Math.log(r.stepsPerSecond()) - meanY);
            xx += x * x;
        }
        return xy / xx;
    }
}
