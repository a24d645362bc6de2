package org.phrenic.patient;

/** Receives the progress of an import. Calls come from any thread, but never concurrently. */
public interface ImportProgress {
    /** Called when a structure has been meshed; {@code count} structures are done. */
    void meshed(int count, int total, String structure);

    /** Called when a stage begins. The text describes it, for example {@code separating the lungs}. */
    default void stage(String what) {}
}
