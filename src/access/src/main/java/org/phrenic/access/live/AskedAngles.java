package org.phrenic.access.live;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.phrenic.access.attempt.NeedleAngles;

/** Angles that a needle by hand has and is asked to have last. On any thread. */
final class AskedAngles {
    private final AtomicReference<NeedleAngles> asked = new AtomicReference<>();
    private volatile NeedleAngles now = new NeedleAngles(0, 0);

    void ask(NeedleAngles to) {
        asked.set(to);
    }

    /** States the angles of the needle. */
    void are(NeedleAngles angles) {
        now = angles;
    }

    /** Ends a request, unless another one has come since. */
    void executed(NeedleAngles request) {
        asked.compareAndSet(request, null);
    }

    /** Ends all requests. */
    void drop() {
        asked.set(null);
    }

    /** Angles asked for, else those of the needle. */
    NeedleAngles askedOrNow() {
        return Optional.ofNullable(asked.get()).orElse(now);
    }
}
