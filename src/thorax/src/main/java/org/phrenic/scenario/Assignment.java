package org.phrenic.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Setting;

/**
 * A typed value for a setting that comes from outside a scenario file. Text is parsed here, once.
 *
 * @param origin where it was given, for messages: {@code --threads 0}
 * @param setting whose value it is
 * @param value of the setting's type
 */
public record Assignment(String origin, Setting<?> setting, Object value) {
    /** Words and numbers that YAML takes for what they say, which it does not of {@code null} and a lone dash. */
    private static final Pattern PLAIN = Pattern.compile("(?!(?:null|Null|NULL|-)$)[A-Za-z0-9_./+-]+");

    /** Creates an assignment from a typed value. */
    public static <T> Assignment of(String origin, Setting<T> setting, T value) {
        return new Assignment(origin, setting, value);
    }

    /**
     * Parses a value; relative paths are resolved against the working directory.
     *
     * @throws BadInputException with one sentence, if the key is unknown or the value is invalid
     */
    public static Assignment read(String origin, String key, String text) {
        return read(origin, key, text, Path.of(""));
    }

    /** As {@link #read(String, String, String)}, with relative paths resolved against another folder. */
    public static Assignment read(String origin, String key, String text, Path folder) {
        try {
            // Text that is not a plain word or number is quoted, so that YAML does not interpret it.
            String escaped = text.isEmpty() || PLAIN.matcher(text).matches() ? text : quote(text);
            YamlMap yaml = YamlDocument.parse(origin, quote(key) + ": " + escaped);
            Settings.requireKeys(yaml);
            Setting<?> setting = Settings.find(key);
            return new Assignment(origin, setting, setting.read(yaml, folder));
        } catch (BadInputException e) {
            // The value comes from no file and its quotes from here, so the message omits line number and quotes.
            String message = e.getMessage().replace(origin + ": line 1, key", origin + ": key");
            throw new BadInputException(message.replace(": found the quoted text '", ": found '"), e);
        }
    }

    /**
     * Parses {@code key=value}, as in {@code --set}.
     *
     * @throws BadInputException if the key or {@code =} is missing, or the value is invalid
     */
    public static Assignment parse(String text) {
        int equals = text.indexOf('=');
        if (equals < 1) {
            throw new BadInputException("--set: found '" + text + "', expected key=value such as depth=1.2");
        }
        if (text.substring(0, equals).strip().equals(RunSettings.CHANGES.key())) {
            throw new BadInputException(
                    "--set " + text + ": found changes, expected them in a scenario file, or as --change of a run");
        }
        return read(
                "--set " + text,
                text.substring(0, equals).strip(),
                text.substring(equals + 1).strip());
    }

    /**
     * Live changes that turn a scenario into another during a run; empty if the scene must be assembled again. Name,
     * steps and scheduled changes are ignored.
     *
     * @param origin of the assignments
     */
    public static Optional<List<Assignment>> liveChanges(Scenario from, Scenario to, String origin) {
        List<Assignment> list = new ArrayList<>();
        for (Setting<?> setting : Settings.all()) {
            boolean counts =
                    setting != RunSettings.NAME && setting != RunSettings.STEPS && setting != RunSettings.CHANGES;
            if (counts && !from.text(setting).equals(to.text(setting))) {
                if (!setting.isLive()) {
                    return Optional.empty();
                }
                list.add(new Assignment(origin, setting, to.get(setting)));
            }
        }
        return Optional.of(list);
    }

    private static String quote(String text) {
        return "'" + text.replace("'", "''") + "'";
    }

    /** Key of the setting. */
    public String key() {
        return setting.key();
    }

    /** The value as text, as in {@code --set}. */
    public String text() {
        return format(setting, value);
    }

    @SuppressWarnings("unchecked") // made with a value of the setting's type
    private static <T> String format(Setting<T> setting, Object value) {
        return setting.format((T) value);
    }

    /**
     * Requires a setting that can change during a run.
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
