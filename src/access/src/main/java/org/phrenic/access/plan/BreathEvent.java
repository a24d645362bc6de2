package org.phrenic.access.plan;

import java.util.Arrays;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * A moment of the breathing that can be waited for: "end-expiration of breath 3".
 *
 * @param kind what happens
 * @param breath in which breath, from 1; empty for the next time
 */
public record BreathEvent(Kind kind, OptionalInt breath) {
    private static final Pattern TEXT = Pattern.compile("([a-z-]+)(?: of breath ([0-9]{1,6}))?");

    /** What can be waited for. */
    public enum Kind {
        /** Air begins to flow in. */
        INSPIRATION,
        END_INSPIRATION,
        /** Air has flowed out: the pause begins or lasts, or the next breath begins. */
        END_EXPIRATION,
        /** The breath is held. */
        HOLD;

        String label() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }

        private static String labels() {
            return Arrays.stream(values()).map(Kind::label).collect(Collectors.joining(", "));
        }
    }

    /**
     * Reads one.
     *
     * @throws IllegalArgumentException with what was found and expected
     */
    public static BreathEvent parse(String text) {
        Matcher m = TEXT.matcher(text.strip());
        if (m.matches()) {
            for (Kind kind : Kind.values()) {
                if (kind.label().equals(m.group(1))) {
                    OptionalInt breath = m.group(2) == null
                            ? OptionalInt.empty()
                            : OptionalInt.of(Math.max(1, Integer.parseInt(m.group(2))));
                    return new BreathEvent(kind, breath);
                }
            }
        }
        throw new IllegalArgumentException("found '" + text + "', expected seconds or one of " + Kind.labels()
                + ", such as 'end-expiration of breath 3'");
    }

    /**
     * Whether it happens now.
     *
     * @param before what the breath did at the look before
     * @param breathBefore its number, from 1
     * @param now what it does
     * @param breathNow its number
     */
    boolean occurs(RespiratoryPhase before, int breathBefore, RespiratoryPhase now, int breathNow) {
        boolean yes =
                switch (kind) {
                    case INSPIRATION ->
                        now == RespiratoryPhase.INSPIRATION && (before != now || breathBefore != breathNow);
                    case END_INSPIRATION -> before == RespiratoryPhase.INSPIRATION && now != before;
                    case END_EXPIRATION ->
                        now == RespiratoryPhase.PAUSE || (before == RespiratoryPhase.EXPIRATION && now != before);
                    case HOLD -> now == RespiratoryPhase.HOLD;
                };
        int number = (kind == Kind.END_EXPIRATION && now != RespiratoryPhase.PAUSE) || kind == Kind.END_INSPIRATION
                ? breathBefore
                : breathNow;
        return yes && (breath.isEmpty() || breath.getAsInt() == number);
    }

    /** "end-expiration of breath 3". */
    public String text() {
        return kind.label() + (breath.isPresent() ? " of breath " + breath.getAsInt() : "");
    }
}
