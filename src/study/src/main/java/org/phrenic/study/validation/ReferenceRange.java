package org.phrenic.study.validation;

import java.util.List;
import java.util.Optional;
import org.phrenic.study.measure.SceneObservables;

/**
 * Published range of one quantity, compared with a simulated breath.
 *
 * @param key unique name in the table
 * @param preset breathing preset; empty for a quantity that the model cannot measure
 * @param body {@code male} or {@code female} if the range is of one sex; empty for all
 * @param observables columns of {@code observables.csv} or of {@link SceneObservables}
 * @param reduction of the observables to one number
 * @param against second observable; empty if none is needed
 * @param againstPreset preset of the second observable, if different
 * @param share of {@link Reduction#AT_SHARE}; 1 for others
 * @param factor that converts the number to the unit
 * @param low lower bound; NaN for none
 * @param high upper bound; NaN for none
 * @param unit of low and high; {@code 1} for a dimensionless number
 * @param confidence in the range
 * @param source publication or other origin
 * @param note remark, or why the quantity cannot be measured; may be empty
 * @param missReason known reason why the model is outside the range; empty if none is known
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
