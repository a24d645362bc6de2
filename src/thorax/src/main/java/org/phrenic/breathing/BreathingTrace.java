package org.phrenic.breathing;

import java.util.Arrays;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.stat.descriptive.rank.Percentile.EstimationType;

/**
 * A recorded breathing signal. Larger values mean deeper inspiration; the unit is that of the recording.
 *
 * <p>The arrays are shared, not copied, and must not be modified.
 *
 * @param name source of the recording
 * @param signal what was read from the source as the signal: a column, or what was computed from columns
 * @param timeS sample times, s, strictly increasing
 * @param amplitude signal
 * @param dropped number of rows left out of the recording because their times did not increase
 */
@SuppressWarnings("ArrayRecordComponent") // samples, read only
public record BreathingTrace(String name, String signal, double[] timeS, double[] amplitude, int dropped) {
    /**
     * Percentile taken as end-expiration when a trace is normalised. A percentile is robust to coughs and artefacts,
     * unlike the extremes.
     */
    public static final double BASELINE_PERCENT = 5;

    public static final double PEAK_PERCENT = 95;

    /** Smallest number of samples that can hold a breath. */
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

    /** Amplitude below which this percentage of the samples lies; linear between samples. */
    public double percentile(double percent) {
        Percentile percentile = new Percentile().withEstimationType(EstimationType.R_7);
        percentile.setData(amplitude);
        return percentile.evaluate(percent);
    }

    /**
     * Normalises to 0 at end-expiration (5th percentile) and 1 at end-inspiration (95th percentile). Values may lie
     * outside 0 to 1.
     *
     * @throws IllegalArgumentException if the signal is constant
     */
    public BreathingTrace normalised() {
        double low = percentile(BASELINE_PERCENT);
        double high = percentile(PEAK_PERCENT);
        if (!(high > low)) {
            throw new IllegalArgumentException(name + ": the signal stays at " + low + ", expected breathing");
        }
        double[] scaled = new double[amplitude.length];
        Arrays.setAll(scaled, i -> (amplitude[i] - low) / (high - low));
        return new BreathingTrace(name, signal, timeS, scaled, dropped);
    }
}
