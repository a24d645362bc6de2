package org.phrenic.ui.access;

import java.util.List;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.ui.session.Session;

/** Restarts the run with a listener for its steps. Used on the event dispatch thread. */
final class ObservedRun {
    private final Session session;

    ObservedRun(Session session) {
        this.session = session;
    }

    /** Restarts at the greatest speed. */
    void restartFast(StepListener.Trigger when, StepListener watch) {
        session.live().setSpeed(Double.POSITIVE_INFINITY);
        restart(when, watch);
    }

    /** Restarts at the speed that the user has set. */
    void restartAtUserSpeed(StepListener.Trigger when, StepListener watch) {
        restart(when, watch);
        restoreUserSpeed();
    }

    private void restart(StepListener.Trigger when, StepListener watch) {
        if (session.scenario().hold()) {
            session.live().change(List.of(Assignment.of("window", Breathing.HOLD, false)));
        }
        session.live().restart(when, watch);
        session.live().play();
    }

    void restoreUserSpeed() {
        session.live().setSpeed(session.speed());
    }

    void stopObserving() {
        session.live().stopListening();
    }
}
