package org.phrenic.study;

import java.util.Locale;
import org.phrenic.file.Numbers;

/** Number formats of reports. */
public final class ReportNumbers {
    private ReportNumbers() {}

    /** Two decimals below 10, one below 100, none from 100 on: 0.12, 12.3, 123; empty for NaN and infinity. */
    public static String number(double value) {
        if (!Double.isFinite(value)) {
            return "";
        }
        double size = Math.abs(value);
        String text = Numbers.format(size >= 100 ? "%.0f" : size >= 10 ? "%.1f" : "%.2f", value);
        return text.matches("-0(\\.0+)?") ? text.substring(1) : text;
    }

    /** As {@link #number}, but three significant digits below 1: 0.00125, 0.120; for quantities of any unit. */
    public static String ofAnySize(double value) {
        return Double.isFinite(value) && value != 0 && Math.abs(value) < 1
                ? Numbers.format("%.3g", value)
                : number(value);
    }

    /** A whole number with thousands separators: 20,909. */
    public static String grouped(double value) {
        return Numbers.format("%,.0f", value);
    }

    /** An enum constant as in files: {@code HIGH} as "high". */
    public static String label(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }
}
