package org.phrenic.study.validation;

import java.util.Arrays;
import java.util.Optional;

/** Confidence in a range of the physiology table. */
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

    /** Tag used in the table. */
    public String tag() {
        return tag;
    }

    /** Whether a value outside such a range makes the validation fail. */
    public boolean isBinding() {
        return binding;
    }

    public String meaning() {
        return meaning;
    }

    /** The constant of a tag; empty if the tag is unknown. */
    public static Optional<Confidence> of(String tag) {
        return Arrays.stream(values()).filter(c -> c.tag.equals(tag)).findFirst();
    }
}
