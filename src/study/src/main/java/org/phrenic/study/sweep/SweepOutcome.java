package org.phrenic.study.sweep;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Result of a run.
 *
 * @param responses one per name
 * @param stateSha256 hash of the final state
 * @param series one row per recorded time series, at equal steps from start to end of the run
 */
public record SweepOutcome(double[] responses, String stateSha256, double[][] series) implements Serializable {
    /** Infinite responses become NaN, which a table shows as an empty cell. */
    public SweepOutcome {
        responses = Arrays.stream(responses)
                .map(value -> Double.isFinite(value) ? value : Double.NaN)
                .toArray();
    }

    /** Points of a recorded time series. */
    public static final int SERIES_POINTS = 41;
}
