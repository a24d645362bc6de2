package org.phrenic.ui;

/** For whom the window is arranged. */
enum Arrangement {
    /** Breathing in everyday words, the phase of the breath, organs; no terms of physics. */
    CLINICIAN("Rehearse liver access"),
    /** All parameters, forces, plots. */
    RESEARCHER("Tune breathing");

    private final String label;

    Arrangement(String label) {
        this.label = label;
    }

    /** The door through which one gets there. */
    String label() {
        return label;
    }
}
