package org.phrenic.breathing;

import java.util.Locale;

/** Phase of the respiratory cycle. */
public enum RespiratoryPhase {
    INSPIRATION,
    EXPIRATION,
    /** At rest between breaths. */
    PAUSE,
    /** Breath hold: at inspiration or expiration, or against a closed glottis. */
    HOLD;

    /** Name in reports and in the window, such as {@code inspiration}. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
