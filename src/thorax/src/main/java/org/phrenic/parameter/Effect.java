package org.phrenic.parameter;

/** What a change of a setting takes in a simulation that runs. */
public enum Effect {
    /** The scene is put together anew. */
    ASSEMBLY(false, true, true),
    /** Another breathing pattern begins with a breath of its own. */
    NEW_PATTERN(true, false, false),
    /** The breathing pattern goes on at the same place with other numbers. */
    PATTERN(true, false, false),
    /** Read at every evaluation of the forces. */
    DRIVE(true, false, false),
    /** Another scheme carries the state from step to step. */
    INTEGRATION(true, false, true),
    /** Another part of the scene at rest, but the same springs and masses. */
    SCENE(true, true, true),
    /** Springs, masses or damping change, and with them the longest stable step. */
    TISSUE(true, true, true);

    private final boolean live;
    private final boolean assembled;
    private final boolean affectsStability;

    Effect(boolean live, boolean assembled, boolean affectsStability) {
        this.live = live;
        this.assembled = assembled;
        this.affectsStability = affectsStability;
    }

    /** Whether it can be changed while the simulation runs. */
    public boolean isLive() {
        return live;
    }

    /** Whether a scene is assembled or settled differently with it. */
    public boolean isAssembled() {
        return assembled;
    }

    /** Whether the longest stable step has to be measured anew. */
    public boolean affectsStability() {
        return affectsStability;
    }
}
