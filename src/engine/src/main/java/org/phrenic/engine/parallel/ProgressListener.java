package org.phrenic.engine.parallel;

/** Told how far a study of many runs is; by any thread, one at a time. */
public interface ProgressListener {
    /** So many of all runs are done, the last of them this. */
    void done(int count, int total, String what);

    /** Something worth saying once. */
    default void note(String sentence) {}
}
