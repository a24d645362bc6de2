package org.phrenic.breathing;

/** Phase of the respiratory cycle. */
public enum RespiratoryPhase {
    INSPIRATION,
    EXPIRATION,
    /** At rest between breaths. */
    PAUSE,
    /** Breath hold: at inspiration or expiration, or against a closed glottis. */
    HOLD
}
