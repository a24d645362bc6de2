package org.phrenic.access.attempt;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/** Takes the snapshots shown in a report: one at each placement on the skin, each sample and each image. */
public final class NeedleSnapshots {
    /** Prefix for the names of the moments of ultrasound images, before their number. */
    static final String IMAGE_PREFIX = "ultrasound_";

    private final List<NeedleSnapshot> snapshots = new ArrayList<>();
    private boolean wasPlaced;
    private int samples;
    private int images;

    /**
     * Observes the needle after all commands of a frame have been executed.
     *
     * @param asked number of images asked for since the start
     */
    public void observe(NeedleInsertion needle, Frame frame, RespiratoryPhase label, int asked) {
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
        while (images < asked) {
            add(IMAGE_PREFIX + ++images, needle, frame, label);
        }
    }

    private void add(String name, NeedleInsertion needle, Frame frame, RespiratoryPhase label) {
        NeedleShaft shaft = needle.shaft();
        double radiusMm = needle.target().radiusMm();
        snapshots.add(new NeedleSnapshot(
                name,
                frame.copy(),
                label,
                shaft.isPlaced(),
                needle.hubNow(),
                shaft.tip(),
                needle.targetNow(),
                radiusMm));
    }

    public List<NeedleSnapshot> all() {
        return List.copyOf(snapshots);
    }
}
