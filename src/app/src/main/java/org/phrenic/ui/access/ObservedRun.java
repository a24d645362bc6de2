package org.phrenic.ui.access;

import java.util.List;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.ui.session.Session;

/** The run behind the clinician's door: begun anew, breathing, with someone watching. On the event dispatch thread. */
final class ObservedRun {
    private final Session session;

    ObservedRun(Session session) {
        this.session = session;
    }

    /** From the start, as fast as it goes. */
    void restartFast(StepListener.Trigger when, StepListener watch) {
        session.live().setSpeed(Double.POSITIVE_INFINITY);
        restart(when, watch);
    }

    /** From the start, as fast as the user chose. */
    void restartAtUserSpeed(StepListener.Trigger when, StepListener watch) {
        restart(when, watch);
        restoreUserSpeed();
    }

    private void restart(StepListener.Trigger when, StepListener watch) {
        if (session.scenario().hold()) {
            session.live().change(List.of(new Assignment("window", "hold", "false")));
        }
        session.live().restart(when, watch);
        session.live().play();
    }

    /** It goes on as fast as the user chose. */
    void restoreUserSpeed() {
        session.live().setSpeed(session.speed());
    }

    /** Nobody watches any more. */
    void stopObserving() {
        session.live().stopListening();
    }
}
