package org.phrenic.ui;

import java.util.List;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.live.Watch;

/** The run behind the clinician's door: begun anew, breathing, with someone watching. On the event dispatch thread. */
final class WatchedRun {
    private final Session session;

    WatchedRun(Session session) {
        this.session = session;
    }

    /** From the start, as fast as it goes. */
    void startFast(Watch.When when, Watch watch) {
        session.live().setSpeed(Double.POSITIVE_INFINITY);
        start(when, watch);
    }

    /** From the start, as fast as the user chose. */
    void startAtSpeed(Watch.When when, Watch watch) {
        start(when, watch);
        atSpeed();
    }

    private void start(Watch.When when, Watch watch) {
        if (session.scenario().hold()) {
            session.live().change(List.of(new Assignment("window", "hold", "false")));
        }
        session.live().restart(when, watch);
        session.live().play();
    }

    /** It goes on as fast as the user chose. */
    void atSpeed() {
        session.live().setSpeed(session.speed());
    }

    /** Nobody watches any more. */
    void leave() {
        session.live().unwatch();
    }
}
