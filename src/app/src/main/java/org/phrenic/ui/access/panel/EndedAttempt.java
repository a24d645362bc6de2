package org.phrenic.ui.access.panel;

import java.util.Optional;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;

/**
 * An attempt of the session that has ended.
 *
 * @param date when it ended, as text
 * @param whole the attempt with the frames of the body of which its report is written; empty if they are not kept
 */
record EndedAttempt(RehearsalPlan plan, AttemptRecord record, ProbeUse probe, String date, Optional<Rehearsal> whole) {
    static EndedAttempt of(Rehearsal attempt, String date) {
        return new EndedAttempt(attempt.plan(), attempt.record(), attempt.probe(), date, Optional.of(attempt));
    }

    /** What table and report card show of it. */
    EndedAttempt withoutFrames() {
        return new EndedAttempt(plan, record, probe, date, Optional.empty());
    }

    boolean goalsReached() {
        return plan.goals().reached(record);
    }
}
