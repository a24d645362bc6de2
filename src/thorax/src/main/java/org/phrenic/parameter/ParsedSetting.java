package org.phrenic.parameter;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.Function;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;

/** A setting whose value is read from and written to a scenario file by functions. */
public final class ParsedSetting<T> extends Setting<T> {
    /** Reads a value of a scenario file; relative paths are resolved against {@code folder}. */
    public interface Reader<T> {
        T read(YamlMap yaml, String key, Path folder);
    }

    private final Function<SettingValues, T> defaultValue;
    private final Reader<T> reader;
    private final Function<T, Object> plain;

    ParsedSetting(
            Declaration declaration,
            Function<SettingValues, T> defaultValue,
            Reader<T> reader,
            Function<T, Object> plain) {
        super(declaration);
        this.defaultValue = defaultValue;
        this.reader = reader;
        this.plain = plain;
    }

    /** A path resolved against a folder, or the exception that names file, line and key. */
    public static Path path(YamlMap yaml, String key, Path folder) {
        try {
            return folder.resolve(yaml.text(key));
        } catch (InvalidPathException e) {
            String problem = "found '" + yaml.text(key) + "', expected a path";
            throw new BadInputException(yaml.bad(key, problem).getMessage(), e);
        }
    }

    @Override
    public T defaultValue(SettingValues values) {
        return defaultValue.apply(values);
    }

    @Override
    public T read(YamlMap yaml, Path folder) {
        return reader.read(yaml, key(), folder);
    }

    @Override
    public Object toPlain(T value) {
        return plain.apply(value);
    }
}
