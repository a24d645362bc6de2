package org.phrenic.rehearsal;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Frame;

/** The moments of an attempt that a report shows: each time that the needle was set on the skin, and each sample. */
final class NeedleViews {
    private final List<NeedleView> views = new ArrayList<>();
    private boolean wasPlaced;
    private int samples;

    /** Looks at the needle after all that was done at a frame. */
    void look(NeedleSession needle, Frame frame, BreathLabel label) {
        if (needle.isPlaced() && !wasPlaced) {
            views.add(NeedleView.of("placed", needle, frame, label));
        }
        wasPlaced = needle.isPlaced();
        int taken = needle.record().samples().size();
        if (taken > samples) {
            views.add(NeedleView.of(taken == 1 ? "sample" : "sample_" + taken, needle, frame, label));
        }
        samples = taken;
    }

    /** All so far, in order. */
    List<NeedleView> all() {
        return List.copyOf(views);
    }
}
