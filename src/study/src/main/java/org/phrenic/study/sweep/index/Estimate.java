package org.phrenic.study.sweep.index;

/**
 * A number with its 95 % confidence interval.
 *
 * @param value estimate from all samples
 * @param low lower end of the interval
 * @param high upper end of the interval
 */
public record Estimate(double value, double low, double high) {
    /** Whether there were enough samples. */
    public boolean isKnown() {
        return Double.isFinite(value);
    }
}
