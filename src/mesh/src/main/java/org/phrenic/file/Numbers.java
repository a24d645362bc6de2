package org.phrenic.file;

import java.util.OptionalDouble;

/** Numbers as people and programs write them in text files: decimal, finite, independent of the locale. */
public final class Numbers {
    private static final int SHOWN_CHARACTERS = 40;

    private Numbers() {}

    /**
     * The finite decimal number {@code text} spells, empty for anything else. Stricter than {@link Double#parseDouble}:
     * no hexadecimal, no type suffix, no NaN, no infinity, no overflow.
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

    /** {@code text} in single quotes for a message: shortened, control characters replaced. */
    public static String quote(String text) {
        StringBuilder shown = new StringBuilder("'");
        for (int i = 0; i < Math.min(text.length(), SHOWN_CHARACTERS); i++) {
            char c = text.charAt(i);
            shown.append(Character.isISOControl(c) ? '?' : c);
        }
        return shown.append(text.length() > SHOWN_CHARACTERS ? "...'" : "'").toString();
    }
}
