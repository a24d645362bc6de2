package org.phrenic.engine.parallel;

/** Receives the progress of a batch of runs. Called from any thread, one at a time. */
public interface ProgressListener {
    /** Called after a run. */
    void done(int count, int total, String what);

    /** Called before the first run with the number of runs that were done before and are counted with the others. */
    default void resumed(int count) {}

    /** Receives a message. */
    default void note(String sentence) {}
}
