package org.phrenic.study.sweep;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.document.Key;

/**
 * A factor of a study and the values that it takes: either a range, a normal distribution or a list.
 *
 * @param key of a parameter or another setting, or of what the model offers besides
 * @param range least and greatest value; with {@code normal}, where the distribution is cut
 * @param log whether the logarithm is uniform in the range
 * @param normal mean and standard deviation of a normal distribution, cut at the range or else at the limits of the
 *     parameter
 * @param values listed values, equally frequent
 * @param levels number of levels of a range in a full grid
 */
public record Factor(
        String key,
        @Key(count = 2) Optional<double[]> range,
        @Key(absent = "false") boolean log,
        @Key(count = 2) Optional<double[]> normal,
        @Key(absent = "") List<String> values,
        @Key(absent = "5", min = 2, max = 10_000) int levels) {
    private static final int DEFAULT_LEVELS = 5;

    /** @throws IllegalArgumentException with one sentence, if the values are not stated in exactly one way */
    public Factor {
        values = List.copyOf(values);
        if (!values.isEmpty() == (range.isPresent() || normal.isPresent())) {
            throw new IllegalArgumentException("factor '" + key + "': found "
                    + (values.isEmpty() ? "no values" : "values and a range") + ", expected range, normal or values");
        }
        range.filter(r -> !(r[0] < r[1])).ifPresent(r -> {
            throw new IllegalArgumentException(
                    "factor '" + key + "': found the range " + r[0] + " to " + r[1] + ", expected the lower end first");
        });
        normal.filter(n -> !(n[1] > 0)).ifPresent(n -> {
            throw new IllegalArgumentException(
                    "factor '" + key + "': found the standard deviation " + n[1] + ", expected more than 0");
        });
        if (log && (range.isEmpty() || normal.isPresent() || range.get()[0] <= 0)) {
            throw new IllegalArgumentException("factor '" + key + "': found log, expected a range above 0 with it");
        }
    }

    /** A factor with listed values. */
    static Factor listed(String key, List<String> values) {
        return new Factor(key, Optional.empty(), false, Optional.empty(), values, DEFAULT_LEVELS);
    }

    /** Whether the values are listed. */
    public boolean isListed() {
        return !values.isEmpty();
    }

    /** The factor as in a study file. */
    Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("key", key);
        range.ifPresent(r -> map.put("range", r));
        normal.ifPresent(n -> map.put("normal", n));
        if (log) {
            map.put("log", true);
        }
        if (isListed()) {
            map.put("values", values);
        } else if (levels != DEFAULT_LEVELS) {
            map.put("levels", levels);
        }
        return map;
    }
}
