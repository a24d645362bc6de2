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

/** Converts the text of options to values, with one sentence for what is wrong. */
public final class OptionValues {
    private OptionValues() {}

    /**
     * A finite number.
     *
     * @param where the option, for the sentence
     * @throws BadInputException with one sentence
     */
    static double number(String where, String text) {
        try {
            double value = Double.parseDouble(text.strip());
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException none) {
            // The message below says it.
        }
        throw new BadInputException(where + ": found '" + text + "', expected a number");
    }

    /** As {@link #number}, and within these bounds. */
    public static double number(String where, String text, double least, double most) {
        double value = number(where, text);
        if (value < least || value > most) {
            throw new BadInputException(
                    where + ": found " + text + ", expected " + format(least) + " to " + format(most));
        }
        return value;
    }

    /** A whole number within these bounds. */
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

    /** Colours over a range given as MIN:MAX. */
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
     * The assignments of {@code --set}.
     *
     * @param reserved keys that are refused
     * @param setter what sets these itself, such as "a validation"
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
     * One of several values, by its name in lower case with hyphens.
     *
     * @throws BadInputException with the nearest name, or all of them
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

    /** The parts of a list with commas; empty parts are kept and refused later. */
    public static List<String> split(String list) {
        return Arrays.stream(list.split(",", -1)).map(String::strip).toList();
    }

    private static String format(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }
}
