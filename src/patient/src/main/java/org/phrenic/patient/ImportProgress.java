package org.phrenic.patient;

/** Receives the progress of an import, from any thread, one call at a time. */
public interface ImportProgress {
    /** A structure is meshed, the {@code count}-th of all. */
    void meshed(int count, int total, String structure);

    /** A stage begins, such as {@code telling the lungs apart}. */
    default void stage(String what) {}
}
