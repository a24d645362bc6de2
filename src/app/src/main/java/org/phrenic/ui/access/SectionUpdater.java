package org.phrenic.ui.access;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.scene.BodySection;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Computes the sections along and across the needle on a thread of its own, at most seven times per second. */
final class SectionUpdater {
    private static final long MIN_INTERVAL_NS = 150_000_000;

    private final FrameWorker worker;
    private final List<Surface> surfaces;
    private final BiConsumer<BodySection, BodySection> listener;

    /**
     * @param frame of these surfaces; overwritten
     * @param shown gets the sections along and across on the event dispatch thread
     */
    SectionUpdater(Executor thread, List<Surface> surfaces, Frame frame, BiConsumer<BodySection, BodySection> shown) {
        worker = new FrameWorker(thread, frame, MIN_INTERVAL_NS);
        this.surfaces = surfaces;
        this.listener = shown;
    }

    /** Takes a frame if the last update is long enough ago; on the simulation's thread. */
    void offer(Frame now, NeedleState state) {
        if (state != null && state.hasNeedle()) {
            worker.offer(now, frame -> {
                BodySection along = BodySection.alongNeedle(surfaces, frame, state);
                BodySection across = BodySection.acrossNeedle(surfaces, frame, state);
                SwingUtilities.invokeLater(() -> listener.accept(along, across));
            });
        }
    }
}
