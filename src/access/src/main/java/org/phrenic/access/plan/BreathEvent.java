package org.phrenic.access.plan;

import java.util.Arrays;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * A breathing event that a step waits for, such as "end-expiration of breath 3".
 *
 * @param breath number of the breath, starting at 1; empty for the next occurrence
 */
public record BreathEvent(Kind kind, OptionalInt breath) {
    private static final Pattern TEXT = Pattern.compile("([a-z-]+)(?: of breath ([1-9][0-9]{0,5}))?");

    /** Kinds of events. */
    public enum Kind {
        INSPIRATION,
        /** The expiration begins, or a breath hold that the breathing pattern has at the end of the inspiration. */
        END_INSPIRATION,
        /**
         * The end-expiratory pause begins or is in progress, or a breath hold that the breathing pattern has at the end
         * of the expiration or the next breath begins.
         */
        END_EXPIRATION,
        /** The breath is held. */
        HOLD;

        String label() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }
    }

    /**
     * Parses an event.
     *
     * @throws IllegalArgumentException if the text is not an event; the message states what was found and expected
     */
    public static BreathEvent parse(String text) {
        Matcher m = TEXT.matcher(text.strip());
        for (Kind kind : Kind.values()) {
            if (m.matches() && kind.label().equals(m.group(1))) {
                String number = m.group(2);
                return new BreathEvent(
                        kind, number == null ? OptionalInt.empty() : OptionalInt.of(Integer.parseInt(number)));
            }
        }
        throw new IllegalArgumentException("found '" + text + "', expected seconds or one of "
                + Arrays.stream(Kind.values()).map(Kind::label).collect(Collectors.joining(", "))
                + ", such as 'end-expiration of breath 3'");
    }

    /**
     * Whether the event occurs between two frames, given the phase and breath number of both. Frames of a breath that
     * is held on command are not given, except for {@link Kind#HOLD}: such a hold may be in the middle of a breath.
     */
    public boolean occurs(RespiratoryPhase before, int breathBefore, RespiratoryPhase now, int breathNow) {
        return occurrence(before, breathBefore, now, breathNow).isPresent();
    }

    /** The number of the breath with the event that occurs between two frames, as {@link #occurs}; empty for none. */
    OptionalInt occurrence(RespiratoryPhase before, int breathBefore, RespiratoryPhase now, int breathNow) {
        boolean occurs =
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
        return occurs && (breath.isEmpty() || breath.getAsInt() == number)
                ? OptionalInt.of(number)
                : OptionalInt.empty();
    }

    /** Text form, such as "end-expiration of breath 3". */
    public String text() {
        return kind.label() + (breath.isPresent() ? " of breath " + breath.getAsInt() : "");
    }
}
