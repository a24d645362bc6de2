package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.YamlMap;
import org.phrenic.file.Numbers;

/** A real-valued setting, such as a time above 0. NaN if a scenario states no value and there is no default. */
public class NumberSetting extends Setting<Double> {
    /**
     * Unit and range of the values offered.
     *
     * @param unit {@code 1} for a dimensionless number
     * @param minimum smallest value offered; except for a {@link Parameter} and unless less is refused, a scenario may
     *     state any number above 0, and 0 if it is the minimum
     * @param maximum largest value offered
     * @param refusesLess whether a scenario may not state less than the minimum, because it would have no effect, or
     *     the run no end
     */
    public record Range(String unit, double minimum, double maximum, boolean refusesLess) {
        public Range(String unit, double minimum, double maximum) {
            this(unit, minimum, maximum, false);
        }
    }

    private final Range range;
    private final ToDoubleFunction<SettingValues> defaultValue;

    NumberSetting(Declaration declaration, Range range, ToDoubleFunction<SettingValues> defaultValue) {
        super(declaration);
        this.range = range;
        this.defaultValue = defaultValue;
    }

    @Override
    public final String unit() {
        return range.unit();
    }

    /** Smallest value offered. */
    public final double minimum() {
        return range.minimum();
    }

    /** Largest value offered. */
    public final double maximum() {
        return range.maximum();
    }

    @Override
    public Double defaultValue(SettingValues values) {
        return defaultValue.applyAsDouble(values);
    }

    @Override
    public Double read(YamlMap yaml, Path folder) {
        double value = yaml.number(key());
        boolean allowed = range.refusesLess() ? value >= minimum() : value > 0 || (value == 0 && minimum() == 0);
        if (!allowed || !(value <= maximum())) {
            String least = range.refusesLess() || minimum() == 0 ? "at least " + number(minimum()) : "more than 0";
            String expected = "expected " + least + ", at most " + number(maximum()) + " " + unit();
            throw yaml.bad(key(), "found " + number(value) + ", " + expected);
        }
        return value;
    }

    @Override
    public Object toPlain(Double value) {
        return Double.isNaN(value) ? null : value;
    }

    @Override
    public String format(Double value) {
        return number(value);
    }

    /** Formats a number for display; a whole number has no fraction digits. */
    public static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? Numbers.format("%.0f", value)
                : Double.toString(value);
    }
}
