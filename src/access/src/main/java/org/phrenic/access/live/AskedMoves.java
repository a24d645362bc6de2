package org.phrenic.access.live;

import java.util.concurrent.atomic.AtomicLong;

/** Counts the moves of a needle that are asked for, carried out and shown. */
final class AskedMoves {
    private final AtomicLong asked = new AtomicLong();
    private long made;
    private volatile long shown;

    /** Counts a move that is asked for; on any thread. Returns the same move, counted when it is carried out. */
    Runnable counted(Runnable move) {
        asked.incrementAndGet();
        return () -> {
            made++;
            move.run();
        };
    }

    /** A state is shown that holds what was carried out; on the thread that does that. */
    void show() {
        shown = made;
    }

    /** Whether a state that is read after this call holds all moves that were asked for; on any thread. */
    boolean areShown() {
        return shown == asked.get();
    }
}
