package org.phrenic.scenario;

import java.util.regex.Pattern;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;

/**
 * A value for a key of a scenario, from elsewhere than its file.
 *
 * @param origin where it was given, for messages: {@code --threads 0}
 * @param key of the scenario
 * @param value as in the file
 */
public record Assignment(String origin, String key, String value) {
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./+-]+");

    /**
     * Reads {@code key=value}, as {@code --set} takes it.
     *
     * @throws BadInputException if there is no key or no {@code =}
     */
    public static Assignment parse(String text) {
        int equals = text.indexOf('=');
        if (equals < 1) {
            throw new BadInputException("--set: found '" + text + "', expected key=value such as depth=1.2");
        }
        return new Assignment(
                "--set " + text,
                text.substring(0, equals).strip(),
                text.substring(equals + 1).strip());
    }

    /**
     * A mapping of this key alone; what is no plain word or number is quoted, so that nothing in it means anything to
     * YAML.
     */
    YamlMap toYaml() {
        String escaped = value.isEmpty() || PLAIN.matcher(value).matches() ? value : quote(value);
        return YamlDocument.parse(origin, quote(key) + ": " + escaped);
    }

    private static String quote(String text) {
        return "'" + text.replace("'", "''") + "'";
    }
}
