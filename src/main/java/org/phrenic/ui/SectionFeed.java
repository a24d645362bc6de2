package org.phrenic.ui;

import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import javax.swing.SwingUtilities;
import org.phrenic.rehearsal.NeedleState;
import org.phrenic.scene.Section;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;

/** Cuts the body along and across the needle, seven times a second at most, on a thread of its own. */
final class SectionFeed implements AutoCloseable {
    private static final long LEAST_NS = 150_000_000;

    private final ExecutorService thread = Executors.newSingleThreadExecutor(r -> {
        Thread made = new Thread(r, "phrenic-section");
        made.setDaemon(true);
        return made;
    });
    private final AtomicBoolean busy = new AtomicBoolean();
    private final List<Surface> surfaces;
    private final Frame frame;
    private final BiConsumer<Section, Section> shown;
    private long lastNs;

    /**
     * @param surfaces of the frames
     * @param frame one of them, to work with
     * @param shown told both sections on the event dispatch thread: along, across
     */
    SectionFeed(List<Surface> surfaces, Frame frame, BiConsumer<Section, Section> shown) {
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
        thread.execute(() -> {
            try {
                Section along = Section.along(surfaces, frame, state);
                Section across = Section.ahead(surfaces, frame, state);
                SwingUtilities.invokeLater(() -> shown.accept(along, across));
            } finally {
                busy.set(false);
            }
        });
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
