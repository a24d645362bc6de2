package org.phrenic.ui.session;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * Numbers as the window shows and reads them: few significant digits, a decimal point whatever the locale, the unit.
 */
public final class NumberFormats {
    /** Digits shown of a value that is set by hand. */
    static final int SIGNIFICANT_DIGITS = 4;

    private static final double MIN_PLAIN = 1e-4;
    private static final double MAX_PLAIN = 1e7;

    private NumberFormats() {}

    /**
     * {@code value} with at most {@link #SIGNIFICANT_DIGITS} significant digits and no trailing zeros: 0.64, 300, 1e-5.
     */
    public static String format(double value) {
        return format(value, SIGNIFICANT_DIGITS);
    }

    /** {@code value} with at most {@code digits} significant digits. */
    public static String format(double value, int digits) {
        if (!Double.isFinite(value)) {
            return "-";
        }
        MathContext rounding = new MathContext(digits, RoundingMode.HALF_EVEN);
        BigDecimal plain = new BigDecimal(value).round(rounding).stripTrailingZeros();
        double size = Math.abs(plain.doubleValue());
        if (size == 0) {
            return "0";
        }
        if (size >= MIN_PLAIN && size < MAX_PLAIN) {
            return plain.toPlainString();
        }
        int exponent = plain.precision() - plain.scale() - 1;
        return plain.movePointLeft(exponent).stripTrailingZeros().toPlainString() + "e" + exponent;
    }

    /** {@code value} with a fixed number of decimals, for numbers that change all the time. */
    public static String fixedDecimals(double value, int decimals) {
        if (!Double.isFinite(value)) {
            return "-";
        }
        String text = text("%." + decimals + "f", value);
        return text.matches("-[0.]+") ? text.substring(1) : text;
    }

    /** {@code value} and its unit: {@code 450 N/m}; a plain number for the unit {@code 1}. */
    public static String withUnit(double value, String unit) {
        return format(value) + unitSuffix(unit);
    }

    /** A space and the unit; empty for {@code 1}. */
    public static String unitSuffix(String unit) {
        return unit.equals("1") ? "" : " " + unit;
    }

    /** Parses a typed number with a decimal point or comma, and perhaps a unit; empty if it is none. */
    public static OptionalDouble parse(String typed) {
        String number = typed.strip().replace(',', '.').replaceFirst("(?<=[0-9.])\\s*[^0-9.eE+\\s-].*$", "");
        try {
            double value = Double.parseDouble(number);
            return Double.isFinite(value) && !number.matches(".*[dDfFxX]$")
                    ? OptionalDouble.of(value)
                    : OptionalDouble.empty();
        } catch (NumberFormatException invalid) {
            return OptionalDouble.empty();
        }
    }

    /** {@link String#format} with a decimal point whatever the locale. */
    public static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
