package org.phrenic.ui.access;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.scene.BodySection;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Computes the sections along and across the needle on a thread of its own, at most seven times per second. */
final class SectionUpdater {
    private static final long MIN_INTERVAL_NS = 150_000_000;

    private final Executor executor;
    private final AtomicBoolean busy = new AtomicBoolean();
    private final List<Surface> surfaces;
    private final Frame frame;
    private final BiConsumer<BodySection, BodySection> listener;
    private long lastUpdateNs;

    /**
     * @param frame of these surfaces; overwritten
     * @param shown gets the sections along and across on the event dispatch thread
     */
    SectionUpdater(Executor thread, List<Surface> surfaces, Frame frame, BiConsumer<BodySection, BodySection> shown) {
        this.executor = thread;
        this.surfaces = surfaces;
        this.frame = frame;
        this.listener = shown;
    }

    /** Takes a frame if the last update is long enough ago; on the simulation's thread. */
    void offer(Frame now, NeedleState state) {
        if (state == null
                || !state.hasNeedle()
                || System.nanoTime() - lastUpdateNs < MIN_INTERVAL_NS
                || !busy.compareAndSet(false, true)) {
            return;
        }
        lastUpdateNs = System.nanoTime();
        frame.copyFrom(now);
        try {
            executor.execute(() -> computeSections(state));
        } catch (RejectedExecutionException closing) {
            // The window is being closed.
            busy.set(false);
        }
    }

    private void computeSections(NeedleState state) {
        try {
            BodySection along = BodySection.alongNeedle(surfaces, frame, state);
            BodySection across = BodySection.acrossNeedle(surfaces, frame, state);
            SwingUtilities.invokeLater(() -> listener.accept(along, across));
        } finally {
            busy.set(false);
        }
    }
}
