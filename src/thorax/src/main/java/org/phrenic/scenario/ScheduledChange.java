package org.phrenic.scenario;

import java.nio.file.Path;
import java.util.function.Function;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * A live change scheduled for a step of a run. As text: {@code 1234:depth=1.5}.
 *
 * @param step number of completed steps at which the change is made; a number ramps in from there
 * @param assignment setting and new value
 */
public record ScheduledChange(long step, Assignment assignment) {
    /** Origin of an assignment that changes nothing and notes that a run goes on from a step. */
    public static final String GOING_ON = "go on";

    /**
     * Parses {@code STEP:key=value}, as in {@code --change}.
     *
     * @throws BadInputException with one sentence, if the format or the value is invalid
     */
    public static ScheduledChange parse(String text) {
        return parse(text, "--change " + text, problem -> new BadInputException("--change: " + problem), Path.of(""));
    }

    /**
     * Parses {@code STEP:key=value}.
     *
     * @param origin where it was given
     * @param bad creates the exception for an invalid format
     * @param folder against which relative paths are resolved
     */
    static ScheduledChange parse(String text, String origin, Function<String, BadInputException> bad, Path folder) {
        int colon = text.indexOf(':');
        int equals = text.indexOf('=');
        String number = text.substring(0, Math.max(0, colon)).strip();
        long step = Numbers.parseWhole(number, 0, Long.MAX_VALUE).orElse(-1);
        if (step < 0 || equals < colon + 2) {
            throw bad.apply(
                    "found '" + text + "', expected STEP:key=value with a step of 0 or more, such as 1234:depth=1.5");
        }
        String key = text.substring(colon + 1, equals).strip();
        return new ScheduledChange(
                step, Assignment.read(origin, key, text.substring(equals + 1).strip(), folder));
    }

    /** Whether it changes nothing and notes that a run goes on from its step. */
    public boolean isOnlyGoingOn() {
        return GOING_ON.equals(assignment.origin());
    }

    /** The change as text, as in scenario files and on the command line. */
    public String text() {
        return step + ":" + assignment.key() + "=" + assignment.text();
    }
}
