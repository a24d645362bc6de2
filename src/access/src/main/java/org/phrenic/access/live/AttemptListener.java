package org.phrenic.access.live;

/** Receives the events of an attempt in a live run, on the thread of the run. */
public interface AttemptListener {
    /** A request could not be executed. */
    void refused(String sentence);

    /** An attempt has ended: the needle was withdrawn after a sample, or the plan is complete. */
    void finished(LiveAttempt attempt);

    /** A plan has ended at a step that could not be executed, of which {@link #refused} has told. */
    default void stopped() {}
}
