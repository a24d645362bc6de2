package org.phrenic.ui.session;

import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.Numbers;

/**
 * Numbers as the window shows and reads them: few significant digits, a decimal point whatever the locale, the unit.
 */
public final class NumberFormats {
    /** Digits shown of a value that is set by hand. */
    static final int SIGNIFICANT_DIGITS = 4;

    private static final Pattern TYPED =
            Pattern.compile("([+-]?(?:\\d+(?:[.,]\\d*)?|[.,]\\d+)(?:[eE][+-]?\\d+)?)\\s*(.*)");

    private static final Pattern GROUPED = Pattern.compile("[+-]?[1-9]\\d{0,2},\\d{3}");

    private NumberFormats() {}

    /**
     * {@code value} with at most {@link #SIGNIFICANT_DIGITS} significant digits and no trailing zeros: 0.64, 300, 1e-5.
     */
    public static String format(double value) {
        return format(value, SIGNIFICANT_DIGITS);
    }

    /** {@code value} as {@link Numbers#trimmed} writes it; a dash for NaN and infinity. */
    public static String format(double value, int digits) {
        return Double.isFinite(value) ? Numbers.trimmed(value, digits) : "-";
    }

    /** {@code value} with a fixed number of decimals, for numbers that change all the time. */
    public static String fixedDecimals(double value, int decimals) {
        if (!Double.isFinite(value)) {
            return "-";
        }
        String text = Numbers.format("%." + decimals + "f", value);
        return text.matches("-[0.]+") ? text.substring(1) : text;
    }

    /** {@code value} and its unit: {@code 450 N/m}; a plain number for the unit {@code 1}. */
    public static String withUnit(double value, String unit) {
        return format(value) + unitSuffix(unit);
    }

    /** Says which end of a range is taken instead of a typed value beyond it. */
    public static String outOfRange(double typed, double taken, String unit) {
        return withUnit(typed, unit) + " is out of range; " + (taken < typed ? "the largest, " : "the smallest, ")
                + withUnit(taken, unit) + ", is taken.";
    }

    /** A space and the unit; empty for {@code 1}. */
    public static String unitSuffix(String unit) {
        return unit.equals("1") ? "" : " " + unit;
    }

    /**
     * Parses a typed number with a decimal point or comma, and perhaps its unit. It is none with another unit, and with
     * a comma that may group thousands: 1,000.
     *
     * @param unit of the number, {@code 1} for none
     * @return the number; empty if the text is none
     */
    public static OptionalDouble parse(String typed, String unit) {
        Matcher text = TYPED.matcher(typed.strip());
        if (!text.matches() || GROUPED.matcher(text.group(1)).matches() || !isUnit(text.group(2), unit)) {
            return OptionalDouble.empty();
        }
        double value = Double.parseDouble(text.group(1).replace(',', '.'));
        return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
    }

    /**
     * Says why {@link #parse} takes no number from a text, in one sentence.
     *
     * @param range that is expected, with its unit
     */
    public static String refusal(String typed, String range, String unit) {
        Matcher text = TYPED.matcher(typed.strip());
        String how = "";
        if (text.matches() && GROUPED.matcher(text.group(1)).matches()) {
            how = ", written without a comma between thousands";
        } else if (text.matches() && !unit.equals("1")) {
            how = ", written in " + unit;
        }
        return "Found '" + typed + "', expected a number from " + range + how + ".";
    }

    /** Whether a text is a unit or nothing; spaces count for nothing, nor does the 1 of {@code 1/min}. */
    private static boolean isUnit(String typed, String unit) {
        return typed.isEmpty() || (!unit.equals("1") && bare(typed).equals(bare(unit)));
    }

    private static String bare(String unit) {
        return unit.replace("\u00b2", "^2").replace(" ", "").replaceFirst("^1(?=/)", "");
    }
}
