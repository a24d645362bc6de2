package org.phrenic.ui.session;

/** For whom the window is arranged. */
public enum Workspace {
    /** Breathing in everyday words, the phase of the breath, organs; no terms of physics. */
    CLINICIAN("Rehearse liver access"),
    /** All parameters, forces, plots. */
    RESEARCHER("Tune breathing");

    private final String label;

    Workspace(String label) {
        this.label = label;
    }

    /** The door through which one gets there. */
    public String label() {
        return label;
    }
}
