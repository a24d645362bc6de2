package org.phrenic.study.validation;

import java.util.List;
import java.util.Optional;
import org.phrenic.study.measure.SceneObservables;

/**
 * One quantity of people that a simulated breath is held against.
 *
 * @param key name, each once in a table
 * @param preset breathing preset; empty for a quantity that cannot be measured here
 * @param body {@code male} or {@code female} where the range is of one sex; empty for all
 * @param observables columns of {@code observables.csv} or of {@link SceneObservables}
 * @param reduction how one number is made of them
 * @param against second observable, empty where none is needed
 * @param againstPreset preset of the second observable where it is another
 * @param share of {@link Reduction#AT_SHARE}; 1 for others
 * @param factor what the number is multiplied with, to have the unit
 * @param low least value; NaN for none
 * @param high greatest value; NaN for none
 * @param unit of low and high; {@code 1} for a plain number
 * @param confidence in the range
 * @param source where it comes from
 * @param note what to know about it, or why it cannot be measured here; may be empty
 * @param missReason why the model misses the range, where it is known to; empty where no reason is known
 */
public record ReferenceRange(
        String key,
        Optional<String> preset,
        Optional<String> body,
        List<String> observables,
        Reduction reduction,
        String against,
        Optional<String> againstPreset,
        double share,
        double factor,
        double low,
        double high,
        String unit,
        Confidence confidence,
        String source,
        String note,
        String missReason) {

    public ReferenceRange {
        observables = List.copyOf(observables);
    }

    /** Whether a value lies in the range; false for NaN. */
    public boolean contains(double value) {
        boolean above = Double.isNaN(low) || value >= low;
        boolean below = Double.isNaN(high) || value <= high;
        return above && below && !Double.isNaN(value);
    }
}
