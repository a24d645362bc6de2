package org.phrenic.patient.numbering;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.phrenic.patient.numbering.VertebraHeights.VertebralEnd;
import org.phrenic.patient.segmentation.Segmentation;

/**
 * Last ribs that are shorter than what is otherwise a fragment of another rib. In people they are 20 to 40 mm long. The
 * scan cuts nothing off them, they begin beside the spine next below the last of the other ribs of their side, and are
 * longer than thick.
 */
final class ShortRibs {
    /** Least distance of the vertebral end below that of the rib above, and greatest, mm. */
    private static final double LEAST_BELOW_MM = 8;

    private static final double MOST_BELOW_MM = 60;

    private static final double LEAST_LENGTH_MM = 15;
    /** Least length over thickness. */
    private static final double LONG = 2;

    private ShortRibs() {}

    /**
     * Moves the last rib of each side from the fragments to the ribs.
     *
     * @param middle x of the median plane, mm
     * @param least number of voxels
     */
    static void take(
            Segmentation s,
            List<RibComponents.Rib> ribs,
            List<RibComponents.Rib> fragments,
            double middle,
            double least) {
        for (boolean left : new boolean[] {false, true}) {
            OptionalDouble lowest = ribs.stream()
                    .filter(rib -> rib.centre[0] > middle == left)
                    .map(rib -> VertebraHeights.vertebralEnd(s, rib, middle))
                    .filter(end -> !end.isCut())
                    .mapToDouble(VertebralEnd::z)
                    .min();
            Optional<RibComponents.Rib> last = fragments.stream()
                    .filter(part -> part.voxels.size() >= least && part.centre[0] > middle == left)
                    .filter(part -> lowest.isPresent() && isLast(s, part, middle, lowest.getAsDouble()))
                    .max(Comparator.comparingInt(part -> part.voxels.size()));
            last.ifPresent(ribs::add);
            last.ifPresent(fragments::remove);
        }
    }

    private static boolean isLast(Segmentation s, RibComponents.Rib part, double middle, double lowest) {
        VertebralEnd end = VertebraHeights.vertebralEnd(s, part, middle);
        double below = lowest - end.z();
        double length = CutRibCount.length(s, part.voxels);
        double thickness = Math.sqrt(part.voxels.size() * s.grid().voxelVolume() / length);
        return end.isWhole()
                && below > LEAST_BELOW_MM
                && below < MOST_BELOW_MM
                && length > Math.max(LEAST_LENGTH_MM, LONG * thickness);
    }
}
