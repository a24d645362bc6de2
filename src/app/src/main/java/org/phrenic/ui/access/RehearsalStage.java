package org.phrenic.ui.access;

/** Stages of a rehearsal. */
public enum RehearsalStage {
    /** Another workspace is shown. */
    CLOSED,
    /** A body is being built. */
    LOADING,
    /** A breath is being recorded. */
    RECORDING_BREATH,
    /** The access map is being computed. */
    MAPPING,
    /** The needle may be used. */
    READY,
    /** A plan is being played. */
    PLAYING,
    /** Liver access cannot be rehearsed on this body. */
    UNAVAILABLE;

    /** Whether holds and restarts of the breath are the rehearsal's, so that its plan has them. */
    public boolean ownsBreath() {
        return this != CLOSED && this != UNAVAILABLE;
    }

    public boolean canStartAttempt() {
        return this == READY || this == PLAYING;
    }
}
