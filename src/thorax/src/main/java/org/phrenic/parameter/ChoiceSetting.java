package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.phrenic.document.KeySuggestion;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;

/** A setting with a fixed list of named values. */
public final class ChoiceSetting<T> extends Setting<T> {
    private final Map<String, T> byName = new LinkedHashMap<>();
    private final Function<T, String> name;
    private final Function<SettingValues, T> defaultValue;

    ChoiceSetting(
            Declaration declaration,
            Collection<T> values,
            Function<T, String> name,
            Function<SettingValues, T> defaultValue) {
        super(declaration);
        values.forEach(value -> byName.put(name.apply(value), value));
        this.name = name;
        this.defaultValue = defaultValue;
    }

    /** Name of a constant in scenario files. */
    public static String nameOf(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }

    @Override
    public List<String> options() {
        return List.copyOf(byName.keySet());
    }

    /** The value with a name; null if there is none. */
    public T named(String option) {
        return byName.get(option);
    }

    @Override
    public T defaultValue(SettingValues values) {
        return defaultValue.apply(values);
    }

    @Override
    public T read(YamlMap yaml, Path folder) {
        String found = yaml.text(key());
        T value = byName.get(found);
        if (value == null) {
            throw unknown(yaml, found);
        }
        return value;
    }

    private BadInputException unknown(YamlMap yaml, String found) {
        String hint = KeySuggestion.nearest(found, options())
                .map(near -> " (did you mean '" + near + "'?)")
                .orElse("");
        return yaml.bad(key(), "found '" + found + "', expected one of " + String.join(", ", options()) + hint);
    }

    @Override
    public Object toPlain(T value) {
        return name.apply(value);
    }
}
