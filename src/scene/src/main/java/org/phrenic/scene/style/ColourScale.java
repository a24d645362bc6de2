package org.phrenic.scene.style;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A range of a quantity shown in the colours of a map.
 *
 * @param map colours
 * @param min value of the first colour
 * @param max value of the last colour
 * @param unit of the values, such as {@code mm}
 */
public record ColourScale(ColourMap map, double min, double max, String unit) {
    private static final List<Double> ROUND_RANGES =
            List.of(1.0, 2.0, 3.0, 5.0, 10.0, 15.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0, 1000.0);

    /** @throws IllegalArgumentException with one sentence, if the range is empty or not finite */
    public ColourScale {
        rangeProblem(min, max).ifPresent(problem -> {
            throw new IllegalArgumentException("colour scale: " + problem);
        });
    }

    /** The smallest round range that holds a value, at most 1000. */
    public static double roundRange(double value) {
        return ROUND_RANGES.stream().filter(range -> range >= value).findFirst().orElse(1000.0);
    }

    /** Magnitudes from 0 to {@code max}. */
    public static ColourScale sequential(double max, String unit) {
        return new ColourScale(ColourMap.VIRIDIS, 0, max, unit);
    }

    /** Values of either sign, from {@code -max} to {@code max}. */
    public static ColourScale diverging(double max, String unit) {
        return new ColourScale(ColourMap.COOL_WARM, -max, max, unit);
    }

    /** Why a range is invalid: "found 5 to 3, expected the smaller number first"; empty if it is valid. */
    public static Optional<String> rangeProblem(double min, double max) {
        if (!Double.isFinite(min) || !Double.isFinite(max)) {
            return Optional.of("found " + min + " to " + max + ", expected two finite numbers");
        }
        if (!(min < max) || !Double.isFinite(max - min)) {
            return Optional.of(String.format(
                    Locale.ROOT, "found %s to %s, expected the smaller number first", plain(min), plain(max)));
        }
        return Optional.empty();
    }

    /** The same colours and unit over another range. */
    public ColourScale withRange(double from, double to) {
        return new ColourScale(map, from, to, unit);
    }

    /** Fraction of the range at a value: 0 at its beginning, 1 at its end, not clamped. */
    public double fraction(double value) {
        return (value - min) / (max - min);
    }

    /** Colour of a value as {@code 0xRRGGBB}; values beyond the range have the colour of that end. */
    public int rgb(double value) {
        return map.rgb(fraction(value));
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? String.format(Locale.ROOT, "%.0f", value)
                : Double.toString(value);
    }
}
