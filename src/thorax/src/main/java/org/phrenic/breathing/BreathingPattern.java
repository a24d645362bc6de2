package org.phrenic.breathing;

/**
 * Breathing as a function of time. Every pattern starts at end-expiration at time 0 and rests there before. Its values
 * are C1-continuous, so that driven parts move smoothly. Implementations are immutable and thread-safe.
 */
public interface BreathingPattern {
    /** Period, s; infinite if the pattern does not repeat. */
    double periodS();

    /**
     * Time that covers everything the pattern does, s; the default duration of a simulation. Two periods by default.
     */
    default double fullDurationS() {
        return 2 * periodS();
    }

    /**
     * Times at which the stretches of a period end, s. Another rate makes the breaths of a stretch shorter, and leaves
     * holds and pauses between breaths as they are. A pattern that does not repeat goes on after the last as in it. One
     * period by default.
     */
    default double[] stretchesS() {
        return new double[] {periodS()};
    }

    /**
     * Writes the state of the drive at a time; allocates nothing.
     *
     * @param timeS time since the start, s
     * @param state receives the result
     */
    void at(double timeS, BreathState state);
}
