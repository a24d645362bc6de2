package org.phrenic.simulation.live;

import java.util.concurrent.atomic.AtomicReference;
import org.phrenic.simulation.observe.Frame;

/**
 * Triple buffer between one writer and its readers. The writer always has a free frame and never blocks on a reader.
 */
final class FrameTripleBuffer {
    private final AtomicReference<Frame> middle;
    private Frame back;
    private Frame front;
    private volatile long published;
    private volatile long taken;

    FrameTripleBuffer(Frame like) {
        back = like.copy();
        middle = new AtomicReference<>(like.copy());
        front = like.copy();
    }

    /** The back frame, used by the writer alone until {@link #publish}. */
    Frame back() {
        return back;
    }

    /** Publishes the back frame as the newest. */
    void publish() {
        long serial = back.serial();
        back = middle.getAndSet(back);
        published = serial;
    }

    /** Whether a reader has taken the newest frame. */
    boolean isConsumed() {
        return taken >= published;
    }

    /**
     * Copies the newest frame if it is newer than {@code into} and of the same scene. Readers block only each other.
     */
    synchronized boolean copyNewest(Frame into) {
        if (!into.isOfSceneOf(front)) {
            return false;
        }
        if (published > front.serial()) {
            front = middle.getAndSet(front);
        }
        taken = Math.max(taken, front.serial());
        if (front.serial() <= into.serial()) {
            return false;
        }
        into.copyFrom(front);
        return true;
    }
}
