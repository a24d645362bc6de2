package org.phrenic.ui.session;

/** A message for the user, one sentence. */
public record SessionMessage(Kind kind, String text) {
    /** Severity. */
    public enum Kind {
        /** Information. */
        NOTE,
        /** A request is refused. */
        REFUSED,
        /** The simulation has diverged and is paused. */
        DIVERGED
    }
}
