package org.phrenic.fit;

/** Told how far a fit is; by any thread, one at a time. */
public interface FitProgress {
    /**
     * An evaluation of the search is done.
     *
     * @param count evaluations so far
     * @param most evaluations at most
     * @param bestMm least mean distance so far
     * @param initialMm mean distance at end-expiration
     */
    void evaluated(int count, int most, double bestMm, double initialMm);

    /** Something worth saying once. */
    default void note(String sentence) {}
}
