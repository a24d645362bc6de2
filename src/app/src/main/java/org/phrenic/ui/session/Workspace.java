package org.phrenic.ui.session;

/** Arrangements of the window for a task. */
public enum Workspace {
    /** Rehearsal of liver access, without terms of physics. */
    CLINICIAN("Rehearse liver access"),
    /** All parameters, forces, plots. */
    RESEARCHER("Tune breathing");

    private final String label;

    Workspace(String label) {
        this.label = label;
    }

    public String label() {
        return label;
    }
}
