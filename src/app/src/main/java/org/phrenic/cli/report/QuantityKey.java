package org.phrenic.cli.report;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Map;

/**
 * Label and unit of a key such as {@code dome_excursion_right_mm}.
 *
 * @param label label, such as {@code dome excursion right}
 * @param unit unit, such as {@code mm}; empty for a dimensionless number
 */
public record QuantityKey(String label, String unit) {
    private static final MathContext SHOWN = new MathContext(5);

    private static final Map<String, String> UNITS = Map.ofEntries(
            Map.entry("_mm", "mm"),
            Map.entry("_mm2", "mm^2"),
            Map.entry("_ml", "ml"),
            Map.entry("_percent", "%"),
            Map.entry("_deg", "deg"),
            Map.entry("_s", "s"));

    public static QuantityKey parse(String key) {
        // A rate keeps its suffix in the label, as in "steps per s".
        String ending = key.endsWith("_per_s")
                ? ""
                : UNITS.keySet().stream().filter(key::endsWith).findFirst().orElse("");
        return new QuantityKey(
                key.substring(0, key.length() - ending.length()).replace('_', ' '), UNITS.getOrDefault(ending, ""));
    }

    /** Formats a value for a table: whole numbers in full, others with five significant digits. */
    public static String format(Object value) {
        if (!(value instanceof Double || value instanceof Float)) {
            return String.valueOf(value);
        }
        double number = ((Number) value).doubleValue();
        if (!Double.isFinite(number)) {
            return "-";
        }
        if (number == Math.rint(number) && Math.abs(number) < 1e9) {
            return Long.toString((long) number);
        }
        BigDecimal rounded = new BigDecimal(number).round(SHOWN).stripTrailingZeros();
        return Math.abs(number) < 1e-4 ? rounded.toString() : rounded.toPlainString();
    }
}
