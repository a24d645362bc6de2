package org.phrenic.ui.session;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Lets the first picture, of the body at rest, come before the first scene is assembled. */
final class FirstPicture {
    /** Longest time for which the assembly waits, s. */
    private static final long WAIT_S = 3;

    private final CountDownLatch drawn;
    private final long longestS;

    /** @param isAwaited whether there will be a picture */
    FirstPicture(boolean isAwaited) {
        this(isAwaited, WAIT_S);
    }

    /** @param longestS longest time for which the assembly waits, s */
    FirstPicture(boolean isAwaited, long longestS) {
        drawn = new CountDownLatch(isAwaited ? 1 : 0);
        this.longestS = longestS;
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
