package org.phrenic.file;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Parses, formats and quotes numbers in text: decimal, independent of the locale. */
public final class Numbers {
    private static final int SHOWN_CHARACTERS = 40;
    /** Size below which a trimmed number has an exponent. */
    private static final double MIN_PLAIN = 1e-4;
    /** Size from which on a trimmed number has an exponent. */
    private static final double MAX_PLAIN = 1e7;

    private Numbers() {}

    /**
     * Parses a finite decimal number; empty if {@code text} is not one. Stricter than {@link Double#parseDouble}: it
     * rejects hexadecimal numbers, type suffixes, NaN, infinity and overflow.
     */
    public static OptionalDouble parse(String text) {
        if (text.isEmpty()) {
            return OptionalDouble.empty();
        }
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            boolean decimal = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
            if (!decimal) {
                return OptionalDouble.empty();
            }
        }
        try {
            double value = Double.parseDouble(text);
            return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
        } catch (NumberFormatException notANumber) {
            return OptionalDouble.empty();
        }
    }

    /** Parses a decimal whole number from {@code min} to {@code max}; empty if {@code text} is not one. */
    public static OptionalLong parseWhole(String text, long min, long max) {
        try {
            long value = Long.parseLong(text);
            return value >= min && value <= max ? OptionalLong.of(value) : OptionalLong.empty();
        } catch (NumberFormatException notWhole) {
            return OptionalLong.empty();
        }
    }

    /** A text in the format of {@link String#format}, with decimal points in every locale. */
    public static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }

    /**
     * A number with at most {@code digits} significant digits and no trailing zeros: 0.64, 300, 123500; with an
     * exponent below 0.0001 and from ten million on: 1e-5. NaN and infinity are written as {@link Double#toString}
     * does.
     */
    public static String trimmed(double value, int digits) {
        if (!Double.isFinite(value)) {
            return Double.toString(value);
        }
        BigDecimal rounded = BigDecimal.valueOf(value)
                .round(new MathContext(digits, RoundingMode.HALF_UP))
                .stripTrailingZeros();
        double size = Math.abs(rounded.doubleValue());
        if (size == 0) {
            return "0";
        }
        if (size >= MIN_PLAIN && size < MAX_PLAIN) {
            return rounded.toPlainString();
        }
        int exponent = rounded.precision() - rounded.scale() - 1;
        return rounded.movePointLeft(exponent).stripTrailingZeros().toPlainString() + "e" + exponent;
    }

    /** Puts {@code text} in single quotes for a message; long text is shortened and control characters are replaced. */
    public static String quote(String text) {
        StringBuilder shown = new StringBuilder("'");
        for (int i = 0; i < Math.min(text.length(), SHOWN_CHARACTERS); i++) {
            char c = text.charAt(i);
            shown.append(Character.isISOControl(c) ? '?' : c);
        }
        return shown.append(text.length() > SHOWN_CHARACTERS ? "...'" : "'").toString();
    }
}
