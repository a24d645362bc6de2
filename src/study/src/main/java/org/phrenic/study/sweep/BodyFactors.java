package org.phrenic.study.sweep;

import static org.phrenic.study.body.BodyVariation.HIGHEST_DOMES_MM;
import static org.phrenic.study.body.BodyVariation.LEAST_SCALE;
import static org.phrenic.study.body.BodyVariation.LOWEST_DOMES_MM;
import static org.phrenic.study.body.BodyVariation.MOST_BARREL;
import static org.phrenic.study.body.BodyVariation.MOST_KYPHOSIS_DEG;
import static org.phrenic.study.body.BodyVariation.MOST_SCALE;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.file.Numbers;
import org.phrenic.study.body.BodyVariation;

/** The factors of size and shape of a body, which vary the body that the scenario names. */
final class BodyFactors {
    private static final String SCALE = "body.scale";
    private static final String SCALE_X = "body.scale_x";
    private static final String SCALE_Y = "body.scale_y";
    private static final String SCALE_Z = "body.scale_z";
    private static final String KYPHOSIS = "body.kyphosis_deg";
    private static final String BARREL = "body.barrel";
    private static final String DOMES = "body.dome_lift_mm";

    private static final Map<String, double[]> LIMITS = new LinkedHashMap<>();

    static {
        for (String scale : List.of(SCALE, SCALE_X, SCALE_Y, SCALE_Z)) {
            LIMITS.put(scale, new double[] {LEAST_SCALE, MOST_SCALE});
        }
        LIMITS.put(KYPHOSIS, new double[] {0, MOST_KYPHOSIS_DEG});
        LIMITS.put(BARREL, new double[] {0, MOST_BARREL});
        LIMITS.put(DOMES, new double[] {LOWEST_DOMES_MM, HIGHEST_DOMES_MM});
    }

    private BodyFactors() {}

    /** All keys. */
    static List<String> keys() {
        return List.copyOf(LIMITS.keySet());
    }

    static boolean has(String key) {
        return LIMITS.containsKey(key);
    }

    static double[] limits(String key) {
        return LIMITS.get(key).clone();
    }

    /** @throws IllegalArgumentException with one sentence, if the value is not a number within the limits */
    static void check(String key, String value) {
        double[] limits = LIMITS.get(key);
        double number = Numbers.parse(value).orElse(Double.NaN);
        if (!(number >= limits[0] && number <= limits[1])) {
            throw new IllegalArgumentException(
                    "factor '" + key + "': found '" + value + "', expected " + limits[0] + " to " + limits[1]);
        }
    }

    /**
     * The variation that the factors of a point state; empty if there are none.
     *
     * @throws IllegalArgumentException with one sentence, if the size and that of an axis together are beyond the
     *     limits
     */
    static Optional<BodyVariation> variation(SweepPoint point) {
        Map<String, Double> stated = new LinkedHashMap<>();
        for (int i = 0; i < point.keys().size(); i++) {
            if (has(point.keys().get(i))) {
                stated.put(
                        point.keys().get(i),
                        Numbers.parse(point.values().get(i)).orElseThrow());
            }
        }
        if (stated.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(new BodyVariation(
                scale(stated, SCALE_X),
                scale(stated, SCALE_Y),
                scale(stated, SCALE_Z),
                stated.getOrDefault(KYPHOSIS, 0.0),
                stated.getOrDefault(BARREL, 0.0),
                stated.getOrDefault(DOMES, 0.0)));
    }

    private static double scale(Map<String, Double> stated, String axis) {
        double all = stated.getOrDefault(SCALE, 1.0);
        double one = stated.getOrDefault(axis, 1.0);
        double scale = all * one;
        if (!(scale >= LEAST_SCALE && scale <= MOST_SCALE)) {
            throw new IllegalArgumentException("factors '" + SCALE + "' and '" + axis + "': found " + all + " times "
                    + one + ", expected a product of " + LEAST_SCALE + " to " + MOST_SCALE);
        }
        return scale;
    }
}
