package org.phrenic.access.attempt;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/** The moments of an attempt that a report shows: each time that the needle was set on the skin, and each sample. */
public final class NeedleSnapshots {
    private final List<NeedleSnapshot> views = new ArrayList<>();
    private boolean wasPlaced;
    private int samples;

    /** Looks at the needle after all that was done at a frame. */
    public void observe(NeedleInsertion needle, Frame frame, RespiratoryPhase label) {
        if (needle.isPlaced() && !wasPlaced) {
            views.add(NeedleSnapshot.of("placed", needle, frame, label));
        }
        wasPlaced = needle.isPlaced();
        int taken = needle.record().samples().size();
        if (taken > samples) {
            views.add(NeedleSnapshot.of(taken == 1 ? "sample" : "sample_" + taken, needle, frame, label));
        }
        samples = taken;
    }

    /** All so far, in order. */
    public List<NeedleSnapshot> all() {
        return List.copyOf(views);
    }
}
