package org.phrenic.study.speed;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.phrenic.anatomy.Resolution;

/**
 * Printed or measured steps per second by resolution and active forces, with derived quantities.
 *
 * @param rows cells; a resolution has all four cases or none
 */
public record SpeedTable(List<Row> rows) {
    /**
     * One cell.
     *
     * @param vertices number of moving vertices
     * @param trials iterations per second of each trial, in the order of measurement; at least one
     */
    public record Row(Resolution resolution, SpeedCase forces, int vertices, List<Double> trials) {
        public Row {
            trials = List.copyOf(trials);
        }

        /** Median of the trials, iterations/s. */
        public double stepsPerS() {
            return median(trials.stream().mapToDouble(Double::doubleValue));
        }
    }

    public SpeedTable {
        rows = List.copyOf(rows);
    }

    /** Table 1 as printed in the paper. */
    public static SpeedTable published() {
        List<Row> rows = new ArrayList<>();
        for (Resolution resolution : Resolution.values()) {
            for (SpeedCase forces : SpeedCase.values()) {
                rows.add(new Row(
                        resolution, forces, resolution.vertices(), List.of(forces.publishedStepsPerS(resolution))));
            }
        }
        return new SpeedTable(rows);
    }

    /** Resolutions of the table, finest first. */
    public List<Resolution> resolutions() {
        return Arrays.stream(Resolution.values())
                .filter(r -> rows.stream().anyMatch(row -> row.resolution() == r))
                .sorted((a, b) -> b.compareTo(a))
                .toList();
    }

    /** The row of a resolution and a case. */
    public Row row(Resolution resolution, SpeedCase forces) {
        return rows.stream()
                .filter(row -> row.resolution() == resolution && row.forces() == forces)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("table: no row of " + resolution + ", " + forces));
    }

    /**
     * Increase of the time per iteration from {@code less} to {@code more}, per cent. It is the median over pairs of
     * consecutive trials, because other load of the machine affects both trials of a pair alike.
     */
    public double overheadPercent(Resolution resolution, SpeedCase more, SpeedCase less) {
        List<Double> slow = row(resolution, more).trials();
        List<Double> fast = row(resolution, less).trials();
        return 100 * (median(IntStream.range(0, slow.size()).mapToDouble(i -> fast.get(i) / slow.get(i))) - 1);
    }

    /** Minimum, mean and maximum of {@link #overheadPercent} over the resolutions. */
    public double[] overheadRange(SpeedCase more, SpeedCase less) {
        DoubleSummaryStatistics all = resolutions().stream()
                .mapToDouble(r -> overheadPercent(r, more, less))
                .summaryStatistics();
        return new double[] {all.getMin(), all.getAverage(), all.getMax()};
    }

    private static double median(DoubleStream values) {
        double[] sorted = values.sorted().toArray();
        return sorted[sorted.length / 2];
    }

    /**
     * Exponent b of time = a · vertices^b, by least squares of the logarithms over the resolutions; empty with fewer
     * than two resolutions.
     */
    public OptionalDouble exponent(SpeedCase forces) {
        List<Row> of = rows.stream().filter(row -> row.forces() == forces).toList();
        if (of.size() < 2) {
            return OptionalDouble.empty();
        }
        SimpleRegression fit = new SimpleRegression();
        of.forEach(row -> fit.addData(StrictMath.log(row.vertices()), -StrictMath.log(row.stepsPerS())));
        return OptionalDouble.of(fit.getSlope());
    }
}
