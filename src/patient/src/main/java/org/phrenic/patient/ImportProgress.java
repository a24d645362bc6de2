package org.phrenic.patient;

/** Told how far an import is; by any thread, one at a time. */
public interface ImportProgress {
    /** So many of all structures are meshed, the last of them this. */
    void meshed(int count, int total, String structure);

    /** What is done now, such as {@code lungs are told apart}. */
    default void stage(String what) {}
}
