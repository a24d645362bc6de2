package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.List;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;
import org.phrenic.document.YamlMap;

/** A setting that is a whole number of at least 1. */
public final class WholeSetting extends Setting<Integer> {
    private static final int MAX_OPTIONS = 16;

    private final int maximum;
    private final ToIntFunction<SettingValues> defaultValue;

    WholeSetting(Declaration declaration, int maximum, ToIntFunction<SettingValues> defaultValue) {
        super(declaration);
        this.maximum = maximum;
        this.defaultValue = defaultValue;
    }

    @Override
    public List<String> options() {
        return maximum > MAX_OPTIONS
                ? List.of()
                : IntStream.rangeClosed(1, maximum).mapToObj(Integer::toString).toList();
    }

    @Override
    public Integer defaultValue(SettingValues values) {
        return defaultValue.applyAsInt(values);
    }

    @Override
    public Integer read(YamlMap yaml, Path folder) {
        long value = yaml.integer(key());
        if (value < 1 || value > maximum) {
            throw yaml.bad(key(), "found " + value + ", expected 1 to " + maximum);
        }
        return (int) value;
    }
}
