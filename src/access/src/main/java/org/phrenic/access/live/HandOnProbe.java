package org.phrenic.access.live;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.phrenic.access.plan.HeldProbe;
import org.phrenic.access.plan.PlanStep;
import org.phrenic.access.plan.ProbeHold;
import org.phrenic.file.BadInputException;

/**
 * The hand that holds the probe of a live run. It may be moved from any thread; the last move within a frame counts.
 */
final class HandOnProbe {
    private final HeldProbe probe;
    private final ManualStepRecorder steps;
    private final AtomicReference<Optional<ProbeHold>> asked = new AtomicReference<>();

    HandOnProbe(HeldProbe probe, ManualStepRecorder steps) {
        this.probe = probe;
        this.steps = steps;
    }

    void ask(Optional<ProbeHold> hold) {
        asked.set(hold);
    }

    boolean isAsked() {
        return asked.get() != null;
    }

    /** Begins to measure anew, with the probe where it is. */
    void begin(double timeS) {
        probe.begin(timeS);
        if (probe.hold().isPresent()) {
            record(timeS);
        }
    }

    /**
     * Moves the probe to where it was asked to be last.
     *
     * @throws BadInputException if that is not on the skin
     */
    void move(double timeS) {
        Optional<ProbeHold> to = asked.getAndSet(null);
        if (to != null) {
            probe.hold(to);
            record(timeS);
        }
    }

    private void record(double timeS) {
        steps.add(timeS, new PlanStep.Probe("by hand, probe", probe.hold()));
    }
}
