package org.phrenic.access.plan;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** What a window shows of the body during an exercise, from most to least help. */
public enum Aids {
    /** The see-through body with needle, target and map, sections and pictures. */
    SEE_THROUGH("See-through body"),
    /** The body from outside, sections along and across the needle, and pictures. */
    SECTIONS("Sections and pictures"),
    /** The body from outside and the pictures of ultrasound and X-ray. */
    PICTURES("Pictures alone");

    private final String label;

    Aids(String label) {
        this.label = label;
    }

    /** Name for people. */
    public String label() {
        return label;
    }

    /** Name in a plan, such as {@code see-through}. */
    public String key() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static Optional<Aids> of(String key) {
        return Arrays.stream(values()).filter(a -> a.key().equals(key)).findFirst();
    }

    static String keys() {
        return Arrays.stream(values()).map(Aids::key).collect(Collectors.joining(", "));
    }
}
