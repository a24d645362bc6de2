package org.phrenic.breathing;

/** What a breath is doing. */
public enum RespiratoryPhase {
    INSPIRATION,
    EXPIRATION,
    /** At rest between breaths. */
    PAUSE,
    /** Held: at inspiration or expiration, or against a closed glottis. */
    HOLD
}
