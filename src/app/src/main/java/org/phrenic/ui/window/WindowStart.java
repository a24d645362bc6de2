package org.phrenic.ui.window;

import org.phrenic.scenario.Scenario;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.ui.session.Session;

/** What begins before the window is made, and goes on beside it. */
final class WindowStart {
    /** Number of processors from which window, picture and scene do not hold each other up while they are made. */
    private static final int PROCESSORS_FOR_ALL = 4;

    private WindowStart() {}

    /**
     * Prepares graphics and body for the window that is made next. On few processors the scene is assembled after the
     * first picture.
     */
    static Session session(Scenario first) {
        OffscreenContext.prepare();
        return new Session(first, Runtime.getRuntime().availableProcessors() < PROCESSORS_FOR_ALL);
    }
}
