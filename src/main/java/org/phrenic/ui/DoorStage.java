package org.phrenic.ui;

/** How far the clinician's door is. */
enum DoorStage {
    /** Another arrangement is used. */
    CLOSED,
    /** A body is being built. */
    LOADING,
    /** A breath is being looked at. */
    LOOKING,
    /** The access map is being worked out. */
    MAPPING,
    /** The needle may be used. */
    READY,
    /** A plan is being played. */
    SHOWING,
    /** This body has no liver access to rehearse. */
    IMPOSSIBLE;

    /** Whether an attempt may begin. */
    boolean mayBegin() {
        return this == READY || this == SHOWING;
    }
}
