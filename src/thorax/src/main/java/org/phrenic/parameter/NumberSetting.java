package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.YamlMap;

/** A setting that is a real number, such as a time above 0. NaN where a scenario leaves it open. */
public class NumberSetting extends Setting<Double> {
    private final String unit;
    private final double minimum;
    private final double maximum;
    private final ToDoubleFunction<SettingValues> defaultValue;

    /**
     * @param minimum least value that is offered; any number above 0 may be stated
     * @param maximum greatest value
     */
    public NumberSetting(
            String key,
            String label,
            Effect effect,
            String unit,
            double minimum,
            double maximum,
            ToDoubleFunction<SettingValues> defaultValue,
            String description) {
        super(key, label, effect, description);
        this.unit = unit;
        this.minimum = minimum;
        this.maximum = maximum;
        this.defaultValue = defaultValue;
    }

    @Override
    public final String unit() {
        return unit;
    }

    /** Least value that is offered. */
    public final double minimum() {
        return minimum;
    }

    /** Greatest value. */
    public final double maximum() {
        return maximum;
    }

    @Override
    public Double defaultValue(SettingValues values) {
        return defaultValue.applyAsDouble(values);
    }

    @Override
    public Double read(YamlMap yaml, Path folder) {
        double value = yaml.number(key());
        if (!(value > 0) || !(value <= maximum)) {
            throw yaml.bad(
                    key(),
                    "found " + number(value) + ", expected more than 0, at most " + number(maximum) + " " + unit);
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
