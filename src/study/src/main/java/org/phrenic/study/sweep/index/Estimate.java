package org.phrenic.study.sweep.index;

/**
 * A number with its 95 % confidence interval.
 *
 * @param value estimate from all samples
 * @param low lower end of the interval; NaN where the samples are too few for one
 * @param high upper end of the interval; NaN where the samples are too few for one
 */
public record Estimate(double value, double low, double high) {
    /** Whether there were enough samples. */
    public boolean isKnown() {
        return Double.isFinite(value);
    }

    /** Whether there were enough samples for an interval. */
    public boolean hasInterval() {
        return Double.isFinite(low) && Double.isFinite(high);
    }
}
