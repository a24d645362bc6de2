package org.phrenic.ui;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import javax.swing.SwingUtilities;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.scene.Section;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;

/** Cuts the body along and across the needle, seven times a second at most, on a thread that is not the simulation's. */
final class SectionFeed {
    private static final long LEAST_NS = 150_000_000;

    private final Executor thread;
    private final AtomicBoolean busy = new AtomicBoolean();
    private final List<Surface> surfaces;
    private final Frame frame;
    private final BiConsumer<Section, Section> shown;
    private long lastNs;

    /**
     * @param thread that cuts
     * @param surfaces of the frames
     * @param frame one of them, to work with
     * @param shown told both sections on the event dispatch thread: along, across
     */
    SectionFeed(Executor thread, List<Surface> surfaces, Frame frame, BiConsumer<Section, Section> shown) {
        this.thread = thread;
        this.surfaces = surfaces;
        this.frame = frame;
        this.shown = shown;
    }

    /** Takes a frame if it is time for one; on the simulation's thread. */
    void offer(Frame now, NeedleState state) {
        if (state == null
                || !state.hasNeedle()
                || System.nanoTime() - lastNs < LEAST_NS
                || !busy.compareAndSet(false, true)) {
            return;
        }
        lastNs = System.nanoTime();
        frame.copyFrom(now);
        try {
            thread.execute(() -> cut(state));
        } catch (RejectedExecutionException closing) {
            // The window is being closed: nobody looks any more.
            busy.set(false);
        }
    }

    private void cut(NeedleState state) {
        try {
            Section along = Section.along(surfaces, frame, state);
            Section across = Section.ahead(surfaces, frame, state);
            SwingUtilities.invokeLater(() -> shown.accept(along, across));
        } finally {
            busy.set(false);
        }
    }
}
