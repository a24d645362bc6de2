package org.phrenic.parameter;

/** Headings under which settings are displayed. */
public enum Group {
    MODEL("Model"),
    MUSCLE("Muscle"),
    TISSUE("Tendon and tissue"),
    BREATHING("Breathing"),
    RIBS("Ribs and sternum"),
    NUMERICS("Numerics");

    private final String label;

    Group(String label) {
        this.label = label;
    }

    /** Display name. */
    public String label() {
        return label;
    }
}
