package org.phrenic.cli.option;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.KeySuggestion;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.style.ColourScale;

/** Converts option text to values. Invalid text causes a {@code BadInputException} with a one-sentence message. */
public final class OptionValues {
    private static final double ROUNDING_S = 1e-9;

    private OptionValues() {}

    /**
     * Parses a finite number.
     *
     * @param where option name for the error message
     * @throws BadInputException if the text is not a finite number
     */
    static double number(String where, String text) {
        return Numbers.parse(text.strip())
                .orElseThrow(() -> new BadInputException(where + ": found '" + text + "', expected a number"));
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
        requireNone(assignments, reserved, setter);
        return assignments;
    }

    /** Refuses assignments of reserved keys; see {@link #assignments}. */
    static void requireNone(List<Assignment> assignments, Set<String> reserved, String setter) {
        assignments.stream().filter(a -> reserved.contains(a.key())).findFirst().ifPresent(a -> {
            throw new BadInputException(
                    a.origin() + ": found a key that " + setter + " sets itself, expected any other key");
        });
    }

    /** Adds the assignment that an option stands for; none if the option is not given. */
    public static void assign(List<Assignment> list, String option, String key, String value) {
        if (value != null) {
            list.add(Assignment.read(option + " " + value, key, value));
        }
    }

    /** The resolution that {@code --resolution} names. */
    public static Resolution resolution(String text) {
        Assignment named = Assignment.read("--resolution " + text, "resolution", text);
        return Scenario.defaults().with(List.of(named)).resolution();
    }

    /** Parses a number of threads; {@code usual} if the option is not given. */
    public static int threads(String text, int usual) {
        return text == null ? usual : integer("--threads", text, 1, Numerics.MAX_THREADS);
    }

    /** The integrator that {@code --integrator} names. */
    public static IntegratorKind integrator(String text) {
        return choice("--integrator", text, List.of(IntegratorKind.values()));
    }

    /** Parses a list of integrators; {@code usual} if the option is not given. */
    public static List<IntegratorKind> integrators(String text, List<IntegratorKind> usual) {
        return text == null
                ? usual
                : split(text).stream().map(OptionValues::integrator).toList();
    }

    /**
     * Parses a list of names.
     *
     * @throws BadInputException if one of them is not among {@code known}
     */
    public static List<String> names(String option, String text, List<String> known) {
        List<String> names = text == null ? List.of() : split(text);
        names.stream().filter(name -> !known.contains(name)).findFirst().ifPresent(name -> {
            throw new BadInputException(option + ": found '" + name + "', expected " + String.join(", ", known));
        });
        return names;
    }

    /**
     * Selects an enum value by its name in lower case with hyphens.
     *
     * @throws BadInputException if no name matches; the message suggests the most similar name or lists all
     */
    public static <E extends Enum<E>> E choice(String option, String found, List<E> values) {
        List<String> labels = values.stream()
                .map(value -> value.name().toLowerCase(Locale.ROOT).replace('_', '-'))
                .toList();
        int index = labels.indexOf(found.strip().toLowerCase(Locale.ROOT));
        if (index < 0) {
            throw new BadInputException(option + ": found '" + found + "', "
                    + KeySuggestion.nearest(found, labels)
                            .map(near -> "did you mean '" + near + "'?")
                            .orElse("expected one of " + String.join(", ", labels)));
        }
        return values.get(index);
    }

    /** Parses a list of simulated times: ascending, each once, s. */
    static double[] times(String option, String list) {
        return split(list).stream()
                .mapToDouble(text -> number(option, text))
                .sorted()
                .distinct()
                .toArray();
    }

    /**
     * Requires that times lie in a scenario.
     *
     * @param totalS duration of the scenario, or the time of its last step
     * @throws BadInputException if a time is negative or after the end
     */
    static void requireWithin(String option, double[] times, double totalS) {
        for (double t : times) {
            if (t < 0 || t > totalS + ROUNDING_S) {
                throw new BadInputException(
                        option + ": found " + t + " s, expected 0 to " + totalS + " s (--duration)");
            }
        }
    }

    /**
     * Requires that no two outputs have one file name.
     *
     * @param names names of the files, in the order of {@code given}
     * @param given what was asked for, as text
     * @param expected what keeps the names apart, for the error message
     */
    static void requireApart(String option, List<String> names, List<String> given, String expected) {
        for (int i = 0; i < names.size(); i++) {
            int first = names.indexOf(names.get(i));
            if (first < i) {
                throw new BadInputException(option + ": found " + given.get(first) + " and " + given.get(i)
                        + ", which give one file " + names.get(i) + ", expected " + expected);
            }
        }
    }

    /** Splits a comma-separated list. Empty parts are kept and rejected later. */
    public static List<String> split(String list) {
        return Arrays.stream(list.split(",", -1)).map(String::strip).toList();
    }

    private static String format(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }
}
