package org.phrenic.study.validation;

import java.util.Arrays;
import java.util.Optional;

/** How far a number of the physiology table can be trusted. */
public enum Confidence {
    SEEN("S", true, "read in a source"),
    MEASURED("M", false, "measured on a public mesh"),
    DERIVED("D", false, "computed from others"),
    CONFIDENT("R+", true, "known from the literature, confident"),
    FAIR("R", false, "known from the literature, fair"),
    WEAK("R-", false, "known from the literature, weak"),
    PAPER("paper", false, "told by Villard, Bourne and Bello 2009");

    private final String tag;
    private final boolean binding;
    private final String meaning;

    Confidence(String tag, boolean binding, String meaning) {
        this.tag = tag;
        this.binding = binding;
        this.meaning = meaning;
    }

    /** As in the table. */
    public String tag() {
        return tag;
    }

    /** Whether a validation fails if such a range is missed. */
    public boolean isBinding() {
        return binding;
    }

    public String meaning() {
        return meaning;
    }

    /** The confidence of this tag; empty if there is none. */
    public static Optional<Confidence> of(String tag) {
        return Arrays.stream(values()).filter(c -> c.tag.equals(tag)).findFirst();
    }
}
