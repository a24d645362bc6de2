package org.phrenic.ui.access;

import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;

/** A rehearsal before its first scene has come. */
public final class IdleRehearsal {
    /** What is done to a rehearsal. */
    public interface Doing {
        void with(Session session, AppearanceModel appearance, SceneViewport view, RehearsalController rehearsal);
    }

    private IdleRehearsal() {}

    /** Makes a rehearsal on the event dispatch thread, does something to it, and ends it. */
    public static void with(Doing what) {
        EventThread.run(() -> {
            Session session = new Session(Scenario.defaults().with("resolution=low"));
            AppearanceModel appearance = new AppearanceModel();
            SceneViewport view = new SceneViewport(session, appearance);
            RehearsalController rehearsal = new RehearsalController(session, appearance, view);
            try {
                what.with(session, appearance, view, rehearsal);
            } finally {
                rehearsal.shutdown();
                view.close();
                session.close();
            }
        });
    }
}
