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

/**
 * Cuts the body along and across the needle, seven times a second at most, on a thread that is not the simulation's.
 */
final class SectionUpdater {
    private static final long MIN_INTERVAL_NS = 150_000_000;

    private final Executor executor;
    private final AtomicBoolean busy = new AtomicBoolean();
    private final List<Surface> surfaces;
    private final Frame frame;
    private final BiConsumer<BodySection, BodySection> listener;
    private long lastUpdateNs;

    /**
     * @param thread that cuts
     * @param surfaces of the frames
     * @param frame one of them, to work with
     * @param shown told both sections on the event dispatch thread: along, across
     */
    SectionUpdater(Executor thread, List<Surface> surfaces, Frame frame, BiConsumer<BodySection, BodySection> shown) {
        this.executor = thread;
        this.surfaces = surfaces;
        this.frame = frame;
        this.listener = shown;
    }

    /** Takes a frame if it is time for one; on the simulation's thread. */
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
            // The window is being closed: nobody looks any more.
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
