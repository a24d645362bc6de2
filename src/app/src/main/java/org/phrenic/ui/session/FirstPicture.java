package org.phrenic.ui.session;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.phrenic.simulation.live.LiveScene;

/**
 * The body at rest that is shown first, and a wait for its picture, which comes before the first scene is assembled.
 */
final class FirstPicture {
    /** Longest time for which the assembly waits, s. */
    private static final long WAIT_S = 3;

    private final CountDownLatch drawn;
    private final long longestS;
    private LiveScene body;
    private boolean over;

    /** @param isAwaited whether there will be a picture */
    FirstPicture(boolean isAwaited) {
        this(isAwaited, WAIT_S);
    }

    /** @param longestS longest time for which the assembly waits, s */
    FirstPicture(boolean isAwaited, long longestS) {
        drawn = new CountDownLatch(isAwaited ? 1 : 0);
        this.longestS = longestS;
    }

    /** A body is there; the first counts, until a scene runs. */
    synchronized void offer(LiveScene atRest) {
        body = body == null && !over ? atRest : body;
    }

    /** The body that is shown first; empty before it is there, and once a scene runs. */
    synchronized Optional<LiveScene> body() {
        return Optional.ofNullable(body);
    }

    /** A scene runs: the body at rest is not shown any more. */
    synchronized void end() {
        over = true;
        body = null;
    }

    /** There is a picture, or there will be none. */
    void endWait() {
        drawn.countDown();
    }

    /** Waits for the picture; an interrupted thread stays interrupted. */
    void await() {
        try {
            drawn.await(longestS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
