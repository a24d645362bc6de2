package org.phrenic.fit;

/** Receives the progress of a fit. Calls come from any thread, but never concurrently. */
public interface FitProgress {
    /**
     * Called after each evaluation of the search.
     *
     * @param count evaluations so far
     * @param most maximum number of evaluations
     * @param bestMm smallest mean distance so far, mm
     * @param initialMm mean distance at end-expiration, mm
     */
    void evaluated(int count, int most, double bestMm, double initialMm);

    /** Receives a message to show once. */
    default void note(String sentence) {}
}
