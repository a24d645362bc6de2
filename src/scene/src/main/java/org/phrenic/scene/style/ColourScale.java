package org.phrenic.scene.style;

import java.util.List;
import java.util.Optional;
import org.phrenic.file.Numbers;

/**
 * A colour map applied to a range of values.
 *
 * @param map colour map
 * @param min value of the first colour
 * @param max value of the last colour
 * @param unit of the values, such as {@code mm}
 */
public record ColourScale(ColourMap map, double min, double max, String unit) {
    private static final List<Double> ROUND_RANGES =
            List.of(1.0, 2.0, 3.0, 5.0, 10.0, 15.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0, 1000.0);

    /** @throws IllegalArgumentException if the range is empty or not finite; the message is one sentence */
    public ColourScale {
        rangeProblem(min, max).ifPresent(problem -> {
            throw new IllegalArgumentException("colour scale: " + problem);
        });
    }

    /** The smallest round range that contains a value, at most 1000. */
    public static double roundRange(double value) {
        return ROUND_RANGES.stream().filter(range -> range >= value).findFirst().orElse(1000.0);
    }

    /** Scale for magnitudes from 0 to {@code max}. */
    public static ColourScale sequential(double max, String unit) {
        return new ColourScale(ColourMap.VIRIDIS, 0, max, unit);
    }

    /** Scale for signed values from {@code -max} to {@code max}. */
    public static ColourScale diverging(double max, String unit) {
        return new ColourScale(ColourMap.COOL_WARM, -max, max, unit);
    }

    /**
     * Describes why a range is invalid, as in "found 5 to 3, expected the smaller number first"; empty if it is valid.
     */
    public static Optional<String> rangeProblem(double min, double max) {
        if (!Double.isFinite(min) || !Double.isFinite(max)) {
            return Optional.of("found " + min + " to " + max + ", expected two finite numbers");
        }
        if (!(min < max) || !Double.isFinite(max - min)) {
            return Optional.of(
                    Numbers.format("found %s to %s, expected the smaller number first", plain(min), plain(max)));
        }
        return Optional.empty();
    }

    public ColourScale withRange(double from, double to) {
        return new ColourScale(map, from, to, unit);
    }

    /** Position of a value in the range: 0 at {@code min}, 1 at {@code max}, not clamped. */
    public double fraction(double value) {
        return (value - min) / (max - min);
    }

    /** Colour of a value as {@code 0xRRGGBB}; values outside the range are clamped. */
    public int rgb(double value) {
        return map.rgb(fraction(value));
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? Numbers.format("%.0f", value)
                : Double.toString(value);
    }
}
