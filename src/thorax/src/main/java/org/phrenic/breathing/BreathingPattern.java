package org.phrenic.breathing;

/**
 * Breathing as a function of time. Every pattern starts at end-expiration at time 0 (and rests there before), and its
 * values are continuous with continuous derivatives, so that nothing it drives is jerked. Immutable, and safe to share.
 */
public interface BreathingPattern {
    /** What to call it in reports. */
    String name();

    /** Seconds after which it repeats itself; infinite if it does not. */
    double periodS();

    /**
     * Seconds after which everything it does has been seen, and what is simulated where nobody says how long: two
     * periods.
     */
    default double fullDurationS() {
        return 2 * periodS();
    }

    /**
     * Writes what is asked of the thorax at a time; allocates nothing.
     *
     * @param timeS seconds since the start
     * @param state receives it
     */
    void at(double timeS, BreathState state);
}
