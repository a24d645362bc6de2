package org.phrenic.study.stability;

/** How a hard case ended. */
public enum CaseOutcome {
    /** Energy, shape and link lengths stayed within the bounds of the case. */
    STABLE("stable"),
    /** A state beyond all bounds was noticed, a good one was put back, and what followed held the bounds. */
    RECOVERED("recovered"),
    /** The scene was refused before it ran, in a sentence that says why. */
    REFUSED("refused"),
    /** A bound was passed and nobody said so: what must not be. */
    SILENT_FAILURE("FAILED SILENTLY");

    private final String label;

    CaseOutcome(String label) {
        this.label = label;
    }

    /** Name for people. */
    public String label() {
        return label;
    }
}
