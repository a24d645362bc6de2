package org.phrenic.file;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Parses and quotes numbers in text files: decimal, finite, independent of the locale. */
public final class Numbers {
    private static final int SHOWN_CHARACTERS = 40;

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
