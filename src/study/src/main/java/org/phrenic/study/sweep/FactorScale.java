package org.phrenic.study.sweep;

import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.phrenic.document.CsvWriter;
import org.phrenic.file.Numbers;

/**
 * Conversion between a coordinate of the unit cube and a value of a factor: the quantile function of its distribution.
 * Numbers have nine significant digits, so that a table of runs states exactly what was computed.
 */
public final class FactorScale {
    private static final int DIGITS = 9;

    private final Factor factor;
    private final double low;
    private final double high;
    private final boolean numeric;
    /** Greatest less least listed number. */
    private final double span;

    private final Map<String, Integer> places = new HashMap<>();

    private FactorScale(Factor factor, double low, double high) {
        this.factor = factor;
        this.low = low;
        this.high = high;
        factor.values().forEach(value -> places.putIfAbsent(value, places.size()));
        numeric = !factor.isListed()
                || factor.values().stream().allMatch(v -> Numbers.parse(v).isPresent());
        DoubleSummaryStatistics numbers =
                factor.values().stream().mapToDouble(this::number).summaryStatistics();
        span = numbers.getMax() - numbers.getMin();
    }

    /**
     * Requires that a model can take the listed values of a factor.
     *
     * @throws IllegalArgumentException with one sentence, if it has no such factor or cannot take a value
     */
    static void requireValues(Factor factor, SweepModel model) {
        factor.values().forEach(value -> model.check(factor.key(), value));
    }

    /**
     * The scale of a factor of a model. Listed values are not read.
     *
     * @throws IllegalArgumentException with one sentence, if the model has no such factor or cannot take its range
     */
    static FactorScale of(Factor factor, SweepModel model) {
        if (factor.isListed()) {
            return new FactorScale(factor, 0, 0);
        }
        double[] limits = model.limits(factor.key());
        if (limits.length == 0) {
            throw new IllegalArgumentException(
                    "factor '" + factor.key() + "': found a range, expected values: it is no number with limits");
        }
        double[] range = factor.range().orElse(limits);
        for (double end : range) {
            if (!(end >= limits[0] && end <= limits[1])) {
                throw new IllegalArgumentException(
                        "factor '" + factor.key() + "': found " + end + ", expected " + limits[0] + " to " + limits[1]);
            }
        }
        return new FactorScale(factor, range[0], range[1]);
    }

    public Factor factor() {
        return factor;
    }

    /** Least and greatest value of a factor without listed values. */
    public double[] range() {
        return new double[] {low, high};
    }

    /** Whether all values are numbers. */
    public boolean isNumeric() {
        return numeric;
    }

    /** The value at a coordinate, as text. */
    String text(double u) {
        if (factor.isListed()) {
            List<String> values = factor.values();
            return values.get(Math.min(values.size() - 1, (int) (u * values.size())));
        }
        return CsvWriter.number(quantile(u), DIGITS);
    }

    private double quantile(double u) {
        if (factor.normal().isPresent()) {
            double[] n = factor.normal().get();
            NormalDistribution normal = new NormalDistribution(null, n[0], n[1]);
            double from = normal.cumulativeProbability(low);
            double to = normal.cumulativeProbability(high);
            double value = normal.inverseCumulativeProbability(from + u * (to - from));
            // Far in a tail the inverse has no finite value; all of the distribution lies at the bound next to its
            // mean.
            return Double.isFinite(value) ? Math.max(low, Math.min(high, value)) : n[0] > high ? high : low;
        }
        if (factor.log()) {
            return low * StrictMath.pow(high / low, u);
        }
        return low + u * (high - low);
    }

    /**
     * Change of the factor from one point to another: of listed names 1 towards a later one and -1 towards an earlier
     * one, otherwise as a share of the range, that is of the listed numbers or of the coordinate.
     *
     * @param from value at the first point
     * @param to value at the second point
     * @param du change of the coordinate
     */
    double change(String from, String to, double du) {
        if (!factor.isListed()) {
            return du;
        }
        double change = number(to) - number(from);
        return numeric ? change / span : Math.signum(change);
    }

    /** The value as a number for statistics: itself, or its place among the different listed values, from 0. */
    public double number(String text) {
        return numeric ? Numbers.parse(text).orElse(Double.NaN) : places.getOrDefault(text, -1);
    }
}
