package org.phrenic.access.live;

import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.plan.HeldProbe;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/** The state of a needle as it is shown: described now and then on the thread that has the frames, read on any. */
final class ShownNeedle {
    /** Wall-clock time between two descriptions, ns. */
    private static final long SHOW_NS = 40_000_000;
    /** Wall-clock time after which the state is described even if nobody takes frames, ns. */
    private static final long IDLE_NS = 120_000_000;

    private final NeedleObserver observer;
    private final HeldProbe probe;
    private final HandOnNeedle grip;
    private final AskedMoves moves;
    private volatile long describedNs;
    private volatile NeedleState state;

    ShownNeedle(NeedleObserver observer, HeldProbe probe, HandOnNeedle grip, AskedMoves moves) {
        this.observer = observer;
        this.probe = probe;
        this.grip = grip;
        this.moves = moves;
    }

    /** Whether it is time for another description. */
    boolean isDue() {
        return state == null || System.nanoTime() - describedNs > SHOW_NS;
    }

    /** Whether the description is so old that a frame is wanted for another. */
    boolean isOld() {
        return System.nanoTime() - describedNs > IDLE_NS;
    }

    void describe(NeedleInsertion needle, Frame frame, RespiratoryPhase phase) {
        describedNs = System.nanoTime();
        describeAtPause(needle, frame, phase);
    }

    /** Describes a needle of a paused run; another description is due as it would be without this one. */
    void describeAtPause(NeedleInsertion needle, Frame frame, RespiratoryPhase phase) {
        state = observer.describe(needle, probe, grip.planned(), frame, phase);
        moves.show();
    }

    /** The state that was described last; null if none was. */
    NeedleState state() {
        return state;
    }
}
