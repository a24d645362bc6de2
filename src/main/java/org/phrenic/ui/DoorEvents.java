package org.phrenic.ui;

import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.scene.Section;

/** What the parts of the clinician's door want to know. */
interface DoorEvents {
    /** Stage, target, entry or advice changed. */
    default void onDoor() {}

    /** An attempt begins. */
    default void onBegin() {}

    /** An attempt has ended and its report is there. */
    default void onAttempt(Rehearsal rehearsal) {}

    /** Other sections. */
    default void onSections(Section along, Section across) {}
}
