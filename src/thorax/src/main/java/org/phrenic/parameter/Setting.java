package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.List;
import org.phrenic.document.YamlMap;

/**
 * Declaration of one key of a scenario. Settings are compared by identity.
 *
 * @param <T> type of its values, which are immutable
 */
public abstract class Setting<T> {
    private final Declaration declaration;

    Setting(Declaration declaration) {
        this.declaration = declaration;
    }

    /** Begins a declaration. */
    public static Declaration named(String key, String label, Effect effect) {
        return new Declaration(key, label, effect, "");
    }

    /** Name in scenario files and on the command line, with its unit. */
    public final String key() {
        return declaration.key();
    }

    /** Display name. */
    public final String label() {
        return declaration.label();
    }

    /** What a running simulation must do when it changes. */
    public final Effect effect() {
        return declaration.effect();
    }

    /** Whether it can change during a run. */
    public final boolean isLive() {
        return effect().isLive();
    }

    /** Its meaning and the origin of its default. */
    public final String description() {
        return declaration.description();
    }

    /** Unit of a number; {@code 1} for a dimensionless number or a value of another type. */
    public String unit() {
        return "1";
    }

    /** Permitted values as in a scenario file; empty if there is no fixed list. */
    public List<String> options() {
        return List.of();
    }

    /** Default value, given the other settings of a scenario. */
    public abstract T defaultValue(SettingValues values);

    /**
     * Reads the value of this key, which must be present.
     *
     * @param folder against which relative paths are resolved
     * @throws org.phrenic.file.BadInputException with one sentence that names file, line and key
     */
    public abstract T read(YamlMap yaml, Path folder);

    /** The value as in a scenario file: a number, boolean, text or list; null if the file omits the key. */
    public Object toPlain(T value) {
        return value;
    }

    /** The value as text, as in {@code --set}; {@code none} for a value that a file omits. */
    public String format(T value) {
        Object plain = toPlain(value);
        return plain == null ? "none" : plain.toString();
    }

    @Override
    public String toString() {
        return key();
    }
}
