package org.phrenic.ui.session;

import java.util.OptionalInt;
import org.phrenic.simulation.live.LiveRun;

/** The recorded frame that is shown; the simulation is paused meanwhile. */
final class LookingBack {
    private static final int PRESENT = -1;

    private final LiveRun live;
    private int frame = PRESENT;
    private boolean resumes;

    LookingBack(LiveRun live) {
        this.live = live;
    }

    /** Shows a frame. */
    void show(int index) {
        if (frame == PRESENT) {
            resumes = live.isPlaying();
            live.pause();
        }
        frame = index;
    }

    /** Leaves the simulation paused once the present is shown again. */
    void stayPaused() {
        resumes = false;
    }

    /** Shows the present, and resumes the simulation if it ran before; false if the present is shown already. */
    boolean end() {
        boolean ended = frame != PRESENT;
        frame = PRESENT;
        if (ended && resumes) {
            live.play();
        }
        return ended;
    }

    /** The frame that is shown; empty for the present. */
    OptionalInt frame() {
        return frame == PRESENT ? OptionalInt.empty() : OptionalInt.of(frame);
    }
}
