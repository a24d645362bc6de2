package org.phrenic.simulation.live;

import java.util.concurrent.atomic.AtomicReference;
import org.phrenic.simulation.observe.Frame;

/**
 * Three frames that go round between one writer and its readers: the writer always has one to write to, and waits for
 * nobody.
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

    /** The frame to write into; the writer's alone until {@link #publish}. */
    Frame back() {
        return back;
    }

    /** Hands over what was written. */
    void publish() {
        long serial = back.serial();
        back = middle.getAndSet(back);
        published = serial;
    }

    /** Whether the last frame was taken, so that another would be seen. */
    boolean isConsumed() {
        return taken >= published;
    }

    /**
     * Copies the newest frame, if it is newer than {@code into} and of the same scene; readers wait for each other
     * alone.
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
