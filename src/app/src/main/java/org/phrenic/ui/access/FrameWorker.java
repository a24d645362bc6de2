package org.phrenic.ui.access;

import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.phrenic.simulation.observe.Frame;

/**
 * Works on frames of a run on another thread, no oftener than an interval. Frames that come while it works are dropped,
 * so work never queues.
 */
final class FrameWorker {
    private final Executor executor;
    private final Frame frame;
    private final long intervalNs;
    private final AtomicBoolean busy = new AtomicBoolean();
    private long lastNs;

    /**
     * @param frame of the same scene; overwritten
     * @param intervalNs least time between the beginnings of two works, ns
     */
    FrameWorker(Executor executor, Frame frame, long intervalNs) {
        this.executor = executor;
        this.frame = frame;
        this.intervalNs = intervalNs;
        lastNs = System.nanoTime() - intervalNs;
    }

    /** Begins to work on a copy of a frame if it is time and nothing is under way; on the simulation's thread. */
    void offer(Frame now, Consumer<Frame> work) {
        long ns = System.nanoTime();
        if (ns - lastNs < intervalNs || !busy.compareAndSet(false, true)) {
            return;
        }
        lastNs = ns;
        frame.copyFrom(now);
        try {
            executor.execute(() -> {
                try {
                    work.accept(frame);
                } finally {
                    busy.set(false);
                }
            });
        } catch (RejectedExecutionException closing) {
            // The window is being closed.
            busy.set(false);
        }
    }
}
