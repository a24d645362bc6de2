package org.phrenic.cli;

import java.util.Arrays;
import java.util.List;
import org.phrenic.format.BadInputException;
import org.phrenic.scene.ColourScale;

/** Numbers and lists that options give as text. */
final class OptionNumbers {
    private OptionNumbers() {}

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
    static double number(String where, String text, double least, double most) {
        double value = number(where, text);
        if (value < least || value > most) {
            throw new BadInputException(
                    where + ": found " + text + ", expected " + plain(least) + " to " + plain(most));
        }
        return value;
    }

    /** A whole number within these bounds. */
    static int whole(String where, String text, int least, int most) {
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
    static ColourScale range(String where, String range, ColourScale usual) {
        int colon = range.indexOf(':');
        if (colon < 1) {
            throw new BadInputException(where + ": found '" + range + "', expected MIN:MAX such as 0:15");
        }
        double min = number(where + " " + range, range.substring(0, colon));
        double max = number(where + " " + range, range.substring(colon + 1));
        ColourScale.problem(min, max).ifPresent(problem -> {
            throw new BadInputException(where + ": " + problem);
        });
        return usual.withRange(min, max);
    }

    /** The parts of a list with commas; empty parts are kept, to be complained about. */
    static List<String> parts(String list) {
        return Arrays.stream(list.split(",", -1)).map(String::strip).toList();
    }

    private static String plain(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }
}
