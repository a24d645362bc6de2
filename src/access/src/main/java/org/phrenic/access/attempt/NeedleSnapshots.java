package org.phrenic.access.attempt;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/** Takes the snapshots shown in a report: one at each placement on the skin and one at each sample. */
public final class NeedleSnapshots {
    private final List<NeedleSnapshot> snapshots = new ArrayList<>();
    private boolean wasPlaced;
    private int samples;

    /** Observes the needle after all commands of a frame have been executed. */
    public void observe(NeedleInsertion needle, Frame frame, RespiratoryPhase label) {
        boolean placed = needle.shaft().isPlaced();
        if (placed && !wasPlaced) {
            add("placed", needle, frame, label);
        }
        wasPlaced = placed;
        int taken = needle.record().samples().size();
        if (taken > samples) {
            add(taken == 1 ? "sample" : "sample_" + taken, needle, frame, label);
        }
        samples = taken;
    }

    private void add(String name, NeedleInsertion needle, Frame frame, RespiratoryPhase label) {
        NeedleShaft shaft = needle.shaft();
        double radiusMm = needle.target().radiusMm();
        snapshots.add(new NeedleSnapshot(
                name, frame.copy(), label, needle.hubNow(), shaft.tip(), needle.targetNow(), radiusMm));
    }

    public List<NeedleSnapshot> all() {
        return List.copyOf(snapshots);
    }
}
