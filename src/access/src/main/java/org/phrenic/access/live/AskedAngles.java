package org.phrenic.access.live;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.phrenic.access.attempt.NeedleAngles;

/** Angles that a needle by hand has and is asked to have; the last of several requests counts. On any thread. */
final class AskedAngles {
    private final AtomicReference<NeedleAngles> asked = new AtomicReference<>();
    private volatile NeedleAngles now = new NeedleAngles(0, 0);

    void ask(NeedleAngles to) {
        asked.set(to);
    }

    /** The angles asked for and not reached yet; empty if there are none. */
    Optional<NeedleAngles> asked() {
        return Optional.ofNullable(asked.get());
    }

    /** States the angles of the needle. */
    void are(NeedleAngles angles) {
        now = angles;
    }

    /** Ends a request, unless another one has come since. */
    void executed(NeedleAngles request) {
        asked.compareAndSet(request, null);
    }

    /** Angles asked for, else those of the needle. */
    NeedleAngles askedOrNow() {
        return asked().orElse(now);
    }
}
