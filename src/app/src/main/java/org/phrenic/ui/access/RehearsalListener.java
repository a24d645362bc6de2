package org.phrenic.ui.access;

import org.phrenic.access.plan.Rehearsal;
import org.phrenic.scene.BodySection;

/** Events of a rehearsal. */
public interface RehearsalListener {
    /** Stage, target, entry or advice has changed. */
    default void onState() {}

    /** An attempt begins. */
    default void onAttemptStarted() {}

    /** An attempt has ended and its report is there. */
    default void onAttemptEnded(Rehearsal rehearsal) {}

    /** Other sections. */
    default void onSections(BodySection along, BodySection across) {}
}
