package org.phrenic.access.attempt;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/**
 * Takes the snapshots shown in a report: one at each placement on the skin, each sample and each image, before anything
 * else is done to the needle.
 */
public final class NeedleSnapshots {
    /** Prefix for the names of the moments of ultrasound images, before their number. */
    static final String IMAGE_PREFIX = "ultrasound_";

    private final List<NeedleSnapshot> snapshots = new ArrayList<>();
    private int placements;
    private int samples;
    private int images;

    /** Observes the needle at a frame and after each command that was executed there. */
    public void observe(NeedleInsertion needle, Frame frame, RespiratoryPhase label) {
        int placed = needle.shaft().placements();
        if (placed > placements) {
            add(numbered("placed", placed), needle, frame, label);
        }
        placements = placed;
        int taken = needle.record().samples().size();
        if (taken > samples) {
            add(numbered("sample", taken), needle, frame, label);
        }
        samples = taken;
    }

    /** Takes a snapshot for an ultrasound image. */
    public void image(NeedleInsertion needle, Frame frame, RespiratoryPhase label) {
        images++;
        add(IMAGE_PREFIX + images, needle, frame, label);
    }

    private static String numbered(String name, int number) {
        return number == 1 ? name : name + "_" + number;
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
