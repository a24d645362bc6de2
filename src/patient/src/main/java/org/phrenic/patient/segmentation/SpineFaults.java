package org.phrenic.patient.segmentation;

import java.util.Optional;
import java.util.OptionalInt;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.label.SpineNames;

/**
 * Faults within the spine from which on the numbers of vertebrae are one off the ribs, while those on the other side
 * are right: two vertebrae under one label, seen by their height, are parted; the halves of one under two labels, seen
 * so too, are joined; a number that is left out between two vertebrae that follow each other is given.
 */
final class SpineFaults {
    private static final int FIRST_ABOVE = RibDeviations.FIRST_ABOVE;

    private final Segmentation s;
    private final RibDeviations ribs;
    private final VertebraHeights height;

    private SpineFaults(Segmentation s, RibDeviations ribs) {
        this.s = s;
        this.ribs = ribs;
        height = new VertebraHeights(s);
    }

    /**
     * Mends the first fault found and numbers anew the side that is one off.
     *
     * @return a note if there is one
     */
    static Optional<String> mend(Segmentation s, RibDeviations ribs) {
        SpineFaults faults = new SpineFaults(s, ribs);
        return faults.partDouble().or(faults::joinHalves).or(faults::closeGap);
    }

    private Optional<String> partDouble() {
        for (int level = FIRST_ABOVE + 1; level <= StructureName.FIRST_LUMBAR; level++) {
            if (height.isDouble(level)) {
                long above = ribs.off(height, FIRST_ABOVE, level - 1);
                long below = ribs.off(height, level + 1, RibNumbering.RIBS);
                if ((above == 1 && below == 0) || (above == 0 && below == -1)) {
                    return Optional.of(part(SpineNames.place(level), above == 1));
                }
            }
        }
        return Optional.empty();
    }

    /**
     * @param place of the vertebra
     * @param upper whether what lies above it is numbered anew, else what lies below
     */
    private String part(int place, boolean upper) {
        String name = SpineNames.at(place);
        String other = SpineNames.at(upper ? place - 2 : place + 2);
        IntList half = VertebraHeights.half(
                s, s.find(name), s.find(SpineNames.at(place - 2)), s.find(SpineNames.at(place + 2)), upper);
        String leftOut = SpineShift.shift(s, upper ? -1 : 1, false, at -> upper ? at < place : at > place);
        s.write(half, s.segment(other));
        s.setLabels(other, s.labels(name));
        String where = upper ? "above" : "below";
        return name + " is as tall as two vertebrae, and those " + where + " it lie one " + where
                + " the ribs of their numbers: they are numbered anew, and it is parted at half its height into " + name
                + " and " + other + leftOut;
    }

    /**
     * Whether the ribs above a fault lie one below their vertebrae, or those below it one above, and the others fit.
     */
    private static boolean isOneOff(OptionalInt above, OptionalInt below) {
        return above.isPresent()
                && below.isPresent()
                && Math.min(above.getAsInt(), -below.getAsInt()) == -1
                && above.getAsInt() * below.getAsInt() == 0;
    }

    private Optional<String> joinHalves() {
        for (int level = FIRST_ABOVE + 1; level <= RibNumbering.RIBS; level++) {
            if (height.areHalves(level)) {
                OptionalInt above = ribs.slip(height, FIRST_ABOVE, level - 1);
                OptionalInt below = ribs.slip(height, level + 2, RibNumbering.RIBS);
                if (isOneOff(above, below)) {
                    int place = SpineNames.place(level);
                    String names = SpineNames.at(place) + " and " + SpineNames.at(place + 2);
                    return Optional.of(names + " together are as tall as one vertebra, and those "
                            + moved(above.getAsInt() == -1, place, place + 2) + ", and the two are "
                            + SpineNames.at(above.getAsInt() == -1 ? place + 2 : place));
                }
            }
        }
        return Optional.empty();
    }

    private Optional<String> closeGap() {
        for (int level = FIRST_ABOVE + 1; level <= RibNumbering.RIBS; level++) {
            if (height.isSkipped(level)) {
                OptionalInt above = ribs.slip(height, FIRST_ABOVE, level - 1);
                OptionalInt below = ribs.slip(height, level, RibNumbering.RIBS);
                if (isOneOff(above, below)) {
                    int place = SpineNames.place(level);
                    return Optional.of(
                            SpineNames.at(place) + " is missing between two that follow each other, and those "
                                    + moved(above.getAsInt() == -1, place - 1, place + 1));
                }
            }
        }
        return Optional.empty();
    }

    /**
     * Moves the vertebrae above a fault one number down, or those below it one up.
     *
     * @param last place of the lowest vertebra or disc above the fault
     * @param first place of the highest one below it
     * @return the end of a note on them
     */
    private String moved(boolean upper, int last, int first) {
        String leftOut = SpineShift.shift(s, upper ? 1 : -1, false, at -> upper ? at <= last : at >= first);
        return (upper ? "above lie one below" : "below lie one above")
                + " the ribs of their numbers: they are numbered anew" + leftOut;
    }
}
