package org.phrenic.cli.option;

import java.util.Arrays;
import java.util.List;
import org.phrenic.file.BadInputException;
import org.phrenic.scene.style.ColourScale;

/** Numbers and lists that options give as text. */
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
            // Told below.
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

    /** The parts of a list with commas; empty parts are kept, to be complained about. */
    public static List<String> split(String list) {
        return Arrays.stream(list.split(",", -1)).map(String::strip).toList();
    }

    private static String format(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }
}
