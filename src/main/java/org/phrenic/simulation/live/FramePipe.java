package org.phrenic.simulation.live;

import java.util.concurrent.atomic.AtomicReference;
import org.phrenic.simulation.Frame;

/** Three frames that go round between one writer and its readers: the writer always has one to write to, and waits for nobody. */
final class FramePipe {
    private final AtomicReference<Frame> middle;
    private Frame writing;
    private Frame reading;
    private volatile long published;
    private volatile long taken;

    FramePipe(Frame like) {
        writing = like.copy();
        middle = new AtomicReference<>(like.copy());
        reading = like.copy();
    }

    /** The frame to write into; the writer's alone until {@link #publish}. */
    Frame writing() {
        return writing;
    }

    /** Hands over what was written. */
    void publish() {
        long serial = writing.serial();
        writing = middle.getAndSet(writing);
        published = serial;
    }

    /** Whether the last frame was taken, so that another would be seen. */
    boolean wanted() {
        return taken >= published;
    }

    /** Copies the newest frame, if it is newer than {@code into} and of the same scene; readers wait for each other alone. */
    synchronized boolean take(Frame into) {
        if (!into.isOfSceneOf(reading)) {
            return false;
        }
        if (published > reading.serial()) {
            reading = middle.getAndSet(reading);
        }
        taken = Math.max(taken, reading.serial());
        if (reading.serial() <= into.serial()) {
            return false;
        }
        into.copyFrom(reading);
        return true;
    }
}
