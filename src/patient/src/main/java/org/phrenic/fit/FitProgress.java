package org.phrenic.fit;

/** Receives the progress of a fit, from any thread, one call at a time. */
public interface FitProgress {
    /**
     * An evaluation of the search is done.
     *
     * @param count evaluations so far
     * @param most the largest number of evaluations
     * @param bestMm least mean distance so far
     * @param initialMm mean distance at end-expiration
     */
    void evaluated(int count, int most, double bestMm, double initialMm);

    /** A sentence to show once. */
    default void note(String sentence) {}
}
