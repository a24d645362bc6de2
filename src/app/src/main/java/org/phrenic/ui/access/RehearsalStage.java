package org.phrenic.ui.access;

/** How far the clinician's door is. */
public enum RehearsalStage {
    /** Another arrangement is used. */
    CLOSED,
    /** A body is being built. */
    LOADING,
    /** A breath is being looked at. */
    RECORDING_BREATH,
    /** The access map is being worked out. */
    MAPPING,
    /** The needle may be used. */
    READY,
    /** A plan is being played. */
    PLAYING,
    /** This body has no liver access to rehearse. */
    UNAVAILABLE;

    /** Whether an attempt may begin. */
    public boolean canStartAttempt() {
        return this == READY || this == PLAYING;
    }
}
