package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.YamlMap;

/** A setting that is a real number, such as a time above 0. NaN where a scenario leaves it open. */
public class NumberSetting extends Setting<Double> {
    /**
     * Which numbers are offered.
     *
     * @param unit {@code 1} for a plain number
     * @param minimum least value that is offered; of what is no {@link Parameter} any number above 0 may be stated
     * @param maximum greatest value
     */
    public record Range(String unit, double minimum, double maximum) {}

    private final Range range;
    private final ToDoubleFunction<SettingValues> defaultValue;

    public NumberSetting(
            String key,
            String label,
            Effect effect,
            Range range,
            ToDoubleFunction<SettingValues> defaultValue,
            String description) {
        super(key, label, effect, description);
        this.range = range;
        this.defaultValue = defaultValue;
    }

    @Override
    public final String unit() {
        return range.unit();
    }

    /** Least value that is offered. */
    public final double minimum() {
        return range.minimum();
    }

    /** Greatest value. */
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
        if (!(value > 0) || !(value <= maximum())) {
            throw yaml.bad(
                    key(),
                    "found " + number(value) + ", expected more than 0, at most " + number(maximum()) + " " + unit());
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

    /** A number for people: without a fraction where it has none. */
    public static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? String.format(Locale.ROOT, "%.0f", value)
                : Double.toString(value);
    }
}
