package org.phrenic.scenario;

import org.phrenic.file.BadInputException;

/**
 * A live change of a running simulation: from which step on which key has another value. As text
 * {@code 1234:depth=1.5}.
 *
 * @param step steps done when it is made; it ramps in from there on
 * @param assignment key and new value
 */
public record ScheduledChange(long step, Assignment assignment) {

    /**
     * Reads {@code STEP:key=value}.
     *
     * @throws BadInputException with one sentence, if it is none
     */
    public static ScheduledChange parse(String text) {
        int colon = text.indexOf(':');
        int equals = text.indexOf('=');
        long step = -1;
        try {
            step = colon < 1 ? -1 : Long.parseLong(text.substring(0, colon).strip());
        } catch (NumberFormatException notWhole) {
            step = -1;
        }
        if (step < 0 || equals < colon + 2) {
            throw new BadInputException("--change: found '" + text
                    + "', expected STEP:key=value with a step of 0 or more, such as 1234:depth=1.5");
        }
        Assignment plain = Assignment.parse(text.substring(colon + 1));
        return new ScheduledChange(step, new Assignment("--change " + text, plain.key(), plain.value()));
    }

    /** As it is written in a scenario and on the command line. */
    public String text() {
        return step + ":" + assignment.key() + "=" + assignment.value();
    }
}
