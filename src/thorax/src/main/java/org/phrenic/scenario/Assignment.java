package org.phrenic.scenario;

import java.nio.file.Path;
import java.util.regex.Pattern;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Setting;

/**
 * A value for a setting, from elsewhere than a scenario's file. Texts become values here, once; from here on the value
 * is typed.
 *
 * @param origin where it was given, for messages: {@code --threads 0}
 * @param setting whose value it is
 * @param value of the setting's type
 */
public record Assignment(String origin, Setting<?> setting, Object value) {
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./+-]+");

    /** A value of a setting. */
    public static <T> Assignment of(String origin, Setting<T> setting, T value) {
        return new Assignment(origin, setting, value);
    }

    /**
     * Reads a value from text; paths are taken from the working folder.
     *
     * @throws BadInputException with one sentence, if the key is unknown or the value cannot be
     */
    public static Assignment read(String origin, String key, String text) {
        return read(origin, key, text, Path.of(""));
    }

    /** As {@link #read(String, String, String)}, with paths taken from another folder. */
    static Assignment read(String origin, String key, String text, Path folder) {
        try {
            // What is no plain word or number is quoted, so that nothing in it means anything to YAML.
            String escaped = text.isEmpty() || PLAIN.matcher(text).matches() ? text : quote(text);
            YamlMap yaml = YamlDocument.parse(origin, quote(key) + ": " + escaped);
            yaml.requireOnly(Settings.keys());
            Setting<?> setting = Settings.find(key);
            return new Assignment(origin, setting, setting.read(yaml, folder));
        } catch (BadInputException e) {
            // A value that comes from no file stands in no line.
            throw new BadInputException(e.getMessage().replace(origin + ": line 1, key", origin + ": key"), e);
        }
    }

    /**
     * Reads {@code key=value}, as {@code --set} takes it.
     *
     * @throws BadInputException if there is no key or no {@code =}, or the value cannot be
     */
    public static Assignment parse(String text) {
        int equals = text.indexOf('=');
        if (equals < 1) {
            throw new BadInputException("--set: found '" + text + "', expected key=value such as depth=1.2");
        }
        return read(
                "--set " + text,
                text.substring(0, equals).strip(),
                text.substring(equals + 1).strip());
    }

    private static String quote(String text) {
        return "'" + text.replace("'", "''") + "'";
    }

    /** Key of the setting. */
    public String key() {
        return setting.key();
    }

    /** The value as text, as {@code --set} takes it. */
    public String text() {
        return format(setting, value);
    }

    @SuppressWarnings("unchecked") // made with a value of the setting's type
    private static <T> String format(Setting<T> setting, Object value) {
        return setting.format((T) value);
    }

    /**
     * Refuses a setting that cannot be changed while a simulation runs.
     *
     * @throws BadInputException with one sentence
     */
    public void requireLive() {
        if (!setting.isLive()) {
            throw new BadInputException(origin + ": found key '" + key()
                    + "', which cannot be changed while the simulation runs; expected one of "
                    + String.join(", ", Settings.liveKeys()));
        }
    }
}
