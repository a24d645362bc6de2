package org.phrenic.parameter;

/** What a running simulation must do when a setting changes. */
public enum Effect {
    /** Assemble the scene again. */
    ASSEMBLY(false, true, true),
    /** Start another breathing pattern from its beginning. */
    NEW_PATTERN(true, false, false),
    /** Continue the breathing pattern at the same phase with other values. */
    PATTERN(true, false, false),
    /** Nothing: the value is read at every force evaluation. */
    DRIVE(true, false, false),
    /** Change the integrator. */
    INTEGRATION(true, false, true),
    /** Update other parts of the scene; springs and masses do not change. */
    SCENE(true, true, true),
    /** Update springs, masses or damping, and with them the stability limit. */
    TISSUE(true, true, true);

    private final boolean live;
    private final boolean assembled;
    private final boolean affectsStability;

    Effect(boolean live, boolean assembled, boolean affectsStability) {
        this.live = live;
        this.assembled = assembled;
        this.affectsStability = affectsStability;
    }

    /** Whether the setting can change during a run. */
    public boolean isLive() {
        return live;
    }

    /** Whether the breathing pattern is made anew from the settings. */
    public boolean isOfPattern() {
        return this == PATTERN || this == NEW_PATTERN;
    }

    /** Whether the setting affects the assembled or settled scene. */
    public boolean isAssembled() {
        return assembled;
    }

    /** Whether the stability limit must be measured again. */
    public boolean affectsStability() {
        return affectsStability;
    }
}
