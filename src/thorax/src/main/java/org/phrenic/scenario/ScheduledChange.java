package org.phrenic.scenario;

import java.nio.file.Path;
import java.util.function.Function;
import org.phrenic.file.BadInputException;

/**
 * A live change of a running simulation: from which step on a setting has another value. As text
 * {@code 1234:depth=1.5}.
 *
 * @param step steps done when it is made; it ramps in from there on
 * @param assignment setting and new value
 */
public record ScheduledChange(long step, Assignment assignment) {

    /**
     * Reads {@code STEP:key=value}, as {@code --change} takes it.
     *
     * @throws BadInputException with one sentence, if it is none or the value cannot be
     */
    public static ScheduledChange parse(String text) {
        return parse(text, "--change " + text, problem -> new BadInputException("--change: " + problem), Path.of(""));
    }

    /**
     * Reads {@code STEP:key=value}.
     *
     * @param origin where it was given
     * @param bad what to throw of a text that is none
     * @param folder from which paths are taken
     */
    static ScheduledChange parse(String text, String origin, Function<String, BadInputException> bad, Path folder) {
        int colon = text.indexOf(':');
        int equals = text.indexOf('=');
        long step = -1;
        try {
            step = colon < 1 ? -1 : Long.parseLong(text.substring(0, colon).strip());
        } catch (NumberFormatException notWhole) {
            step = -1;
        }
        if (step < 0 || equals < colon + 2) {
            throw bad.apply(
                    "found '" + text + "', expected STEP:key=value with a step of 0 or more, such as 1234:depth=1.5");
        }
        String key = text.substring(colon + 1, equals).strip();
        return new ScheduledChange(
                step, Assignment.read(origin, key, text.substring(equals + 1).strip(), folder));
    }

    /** As it is written in a scenario and on the command line. */
    public String text() {
        return step + ":" + assignment.key() + "=" + assignment.text();
    }
}
