package org.phrenic.breathing;

import java.util.Arrays;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.stat.descriptive.rank.Percentile.EstimationType;

/**
 * A recorded breathing signal: larger is deeper, in whatever unit it was recorded.
 *
 * <p>The arrays are shared, not copied, and must not be written to by those who receive them.
 *
 * @param name where it came from
 * @param timeS seconds, rising strictly
 * @param amplitude the signal
 * @param dropped rows of the recording left out because their times did not rise
 */
@SuppressWarnings("ArrayRecordComponent") // samples, read only
public record BreathingTrace(String name, double[] timeS, double[] amplitude, int dropped) {
    /**
     * End-expiration and end-inspiration of a normalised trace: these percentiles, so that a cough or a slip sets no
     * scale.
     */
    public static final double BASELINE_PERCENT = 5;

    public static final double PEAK_PERCENT = 95;

    /** Fewer samples hold no breath. */
    private static final int MIN_SAMPLES = 8;

    public BreathingTrace {
        if (timeS.length != amplitude.length || timeS.length < MIN_SAMPLES) {
            throw new IllegalArgumentException(name + ": " + timeS.length + " times and " + amplitude.length
                    + " values, expected as many of both and at least " + MIN_SAMPLES);
        }
        for (int i = 0; i < timeS.length; i++) {
            if (!Double.isFinite(timeS[i]) || !Double.isFinite(amplitude[i])) {
                throw new IllegalArgumentException(name + ": sample " + (i + 1) + " is (" + timeS[i] + ", "
                        + amplitude[i] + "), expected finite numbers");
            }
            if (i > 0 && timeS[i] <= timeS[i - 1]) {
                throw new IllegalArgumentException(name + ": sample " + (i + 1) + " has time " + timeS[i]
                        + " s, expected more than the " + timeS[i - 1] + " s before it");
            }
        }
    }

    /** Without its straight line of least squares: a body that sinks into the couch, a drifting sensor. */
    public BreathingTrace detrended() {
        int count = timeS.length;
        double meanTime = Arrays.stream(timeS).sum() / count;
        double mean = Arrays.stream(amplitude).sum() / count;
        double product = 0;
        double square = 0;
        for (int i = 0; i < count; i++) {
            product += (timeS[i] - meanTime) * (amplitude[i] - mean);
            square += (timeS[i] - meanTime) * (timeS[i] - meanTime);
        }
        double[] level = new double[count];
        for (int i = 0; i < count; i++) {
            level[i] = amplitude[i] - product / square * (timeS[i] - meanTime);
        }
        return new BreathingTrace(name, timeS, level, dropped);
    }

    /**
     * From 0 at end-expiration (the 5th percentile) to 1 at end-inspiration (the 95th); single values lie beyond both.
     *
     * @throws IllegalArgumentException if the signal does not change
     */
    public BreathingTrace normalised() {
        Percentile percentile = new Percentile().withEstimationType(EstimationType.R_7);
        percentile.setData(amplitude);
        double low = percentile.evaluate(BASELINE_PERCENT);
        double high = percentile.evaluate(PEAK_PERCENT);
        if (!(high > low)) {
            throw new IllegalArgumentException(name + ": the signal stays at " + low + ", expected breathing");
        }
        double[] scaled = new double[amplitude.length];
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] = (amplitude[i] - low) / (high - low);
        }
        return new BreathingTrace(name, timeS, scaled, dropped);
    }
}
