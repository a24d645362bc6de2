package org.phrenic.parameter;

import java.nio.file.Path;
import java.util.List;
import org.phrenic.document.YamlMap;

/**
 * The declaration of one key of a scenario. Two settings are the same only if they are one object.
 *
 * @param <T> type of its values, which are immutable
 */
public abstract class Setting<T> {
    private final String key;
    private final String label;
    private final Effect effect;
    private final String description;

    /**
     * @param key name in scenario files and on the command line, with its unit
     * @param label name for people
     * @param description what it is and where its default comes from, in one or two sentences
     */
    protected Setting(String key, String label, Effect effect, String description) {
        this.key = key;
        this.label = label;
        this.effect = effect;
        this.description = description;
    }

    /** Name in scenario files and on the command line, with its unit. */
    public final String key() {
        return key;
    }

    /** Name for people. */
    public final String label() {
        return label;
    }

    /** What a change of it takes while a simulation runs. */
    public final Effect effect() {
        return effect;
    }

    /** Whether it can be changed while a simulation runs. */
    public final boolean isLive() {
        return effect.isLive();
    }

    /** What it is and where its default comes from. */
    public final String description() {
        return description;
    }

    /** Unit of a number; {@code 1} for a plain one and for what is no number. */
    public String unit() {
        return "1";
    }

    /** Values to choose from, as a scenario file has them; empty if there is no such list. */
    public List<String> options() {
        return List.of();
    }

    /** Value of a scenario that states none. */
    public abstract T defaultValue(SettingValues values);

    /**
     * Reads the value of this key, which is there.
     *
     * @param folder from which paths are taken
     * @throws org.phrenic.file.BadInputException with one sentence that names file, line and key
     */
    public abstract T read(YamlMap yaml, Path folder);

    /**
     * The value as a scenario file has it: a number, a truth value, a text or a list; null where the file leaves the
     * key out.
     */
    public Object toPlain(T value) {
        return value;
    }

    /** The value as text, as {@code --set} takes it. */
    public String format(T value) {
        return String.valueOf(toPlain(value));
    }

    @Override
    public String toString() {
        return key;
    }
}
