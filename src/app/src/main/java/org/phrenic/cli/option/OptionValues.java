package org.phrenic.cli.option;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.phrenic.document.KeySuggestion;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Assignment;
import org.phrenic.scene.style.ColourScale;

/** Converts option text to values. Invalid text causes a {@code BadInputException} with a one-sentence message. */
public final class OptionValues {
    private OptionValues() {}

    /**
     * Parses a finite number.
     *
     * @param where option name for the error message
     * @throws BadInputException if the text is not a finite number
     */
    static double number(String where, String text) {
        try {
            double value = Double.parseDouble(text.strip());
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException none) {
            // Reported below.
        }
        throw new BadInputException(where + ": found '" + text + "', expected a number");
    }

    /** Parses a finite number within bounds, both inclusive. */
    public static double number(String where, String text, double least, double most) {
        double value = number(where, text);
        if (value < least || value > most) {
            throw new BadInputException(
                    where + ": found " + text + ", expected " + format(least) + " to " + format(most));
        }
        return value;
    }

    /** Parses a whole number within bounds, both inclusive. */
    public static int integer(String where, String text, int least, int most) {
        double value = number(where, text);
        if (value != Math.rint(value)) {
            throw new BadInputException(where + ": found '" + text + "', expected a whole number");
        }
        if (value < least || value > most) {
            throw new BadInputException(where + ": found " + text + ", expected " + least + " to " + most);
        }
        return (int) value;
    }

    /** A colour scale with the colours and unit of {@code usual} and a range given as MIN:MAX. */
    public static ColourScale range(String where, String range, ColourScale usual) {
        int colon = range.indexOf(':');
        if (colon < 1) {
            throw new BadInputException(where + ": found '" + range + "', expected MIN:MAX such as 0:15");
        }
        double min = number(where + " " + range, range.substring(0, colon));
        double max = number(where + " " + range, range.substring(colon + 1));
        ColourScale.rangeProblem(min, max).ifPresent(problem -> {
            throw new BadInputException(where + ": " + problem);
        });
        return usual.withRange(min, max);
    }

    /**
     * Parses the assignments of {@code --set}.
     *
     * @param reserved keys that are rejected
     * @param setter what sets the reserved keys, for the error message, such as "a validation"
     */
    public static List<Assignment> assignments(List<String> settings, Set<String> reserved, String setter) {
        List<Assignment> assignments = settings.stream().map(Assignment::parse).toList();
        assignments.stream().filter(a -> reserved.contains(a.key())).findFirst().ifPresent(a -> {
            throw new BadInputException(
                    a.origin() + ": found a key that " + setter + " sets itself, expected any other key");
        });
        return assignments;
    }

    /**
     * Selects an enum value by its name in lower case with hyphens.
     *
     * @throws BadInputException if no name matches; the message suggests the most similar name or lists all
     */
    public static <E extends Enum<E>> E choice(String option, String found, List<E> values) {
        Map<String, E> byLabel = new LinkedHashMap<>();
        values.forEach(
                value -> byLabel.put(value.name().toLowerCase(Locale.ROOT).replace('_', '-'), value));
        E value = byLabel.get(found.strip().toLowerCase(Locale.ROOT));
        if (value == null) {
            throw new BadInputException(option + ": found '" + found + "', "
                    + KeySuggestion.nearest(found, byLabel.keySet())
                            .map(near -> "did you mean '" + near + "'?")
                            .orElse("expected one of " + String.join(", ", byLabel.keySet())));
        }
        return value;
    }

    /** Splits a comma-separated list. Empty parts are kept and rejected later. */
    public static List<String> split(String list) {
        return Arrays.stream(list.split(",", -1)).map(String::strip).toList();
    }

    private static String format(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }
}
