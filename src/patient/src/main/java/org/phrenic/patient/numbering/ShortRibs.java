package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.patient.numbering.VertebraHeights.VertebralEnd;
import org.phrenic.patient.segmentation.Segmentation;

/**
 * Last ribs that are shorter than what is otherwise a fragment of another rib. In people they are 20 to 40 mm long. The
 * scan cuts nothing off them, they begin beside the spine next below the last of the other ribs of their side, and are
 * longer than thick. Ribs of a lumbar vertebra and its transverse processes are as short: a last rib begins nearer to
 * the usual end of the twelfth rib than to the first lumbar vertebra, or without vertebrae below a rib that is no
 * twelfth, and is the twelfth at most.
 */
final class ShortRibs {
    /** Least distance of the vertebral end below that of the rib above, and greatest, mm. */
    private static final double LEAST_BELOW_MM = 8;

    private static final double MOST_BELOW_MM = 60;

    private static final double LEAST_LENGTH_MM = 15;
    /** Least length over thickness. */
    private static final double LONG = 2;

    private record Ending(RibComponents.Rib rib, VertebralEnd end) {}

    private final Segmentation s;
    private final List<RibComponents.Rib> ribs;
    private final List<RibComponents.Rib> fragments;
    /** x of the median plane, mm. */
    private final double middle;

    private final List<RibComponents.Rib> taken = new ArrayList<>();

    ShortRibs(Segmentation s, List<RibComponents.Rib> ribs, List<RibComponents.Rib> fragments, double middle) {
        this.s = s;
        this.ribs = ribs;
        this.fragments = fragments;
        this.middle = middle;
    }

    /**
     * Moves the last rib of each side from the fragments to the ribs.
     *
     * @param least number of voxels
     */
    void take(double least) {
        for (boolean left : new boolean[] {false, true}) {
            List<RibComponents.Rib> parts = fragments.stream()
                    .filter(part -> part.voxels.size() >= least && isLeft(part) == left)
                    .sorted(Comparator.comparingInt(part -> -part.voxels.size()))
                    .toList();
            List<Ending> above = parts.isEmpty() ? List.of() : lowest(left);
            Optional<RibComponents.Rib> last = parts.stream()
                    .filter(part -> !above.isEmpty() && isLast(part, above))
                    .findFirst();
            last.ifPresent(ribs::add);
            last.ifPresent(taken::add);
            last.ifPresent(fragments::remove);
        }
    }

    /** Moves those back that lie below twelve others, when the ribs that hang together or are broken are told. */
    void giveBack() {
        for (RibComponents.Rib rib : taken) {
            if (ofSide(isLeft(rib)).count() > RibNumbering.RIBS && ribs.remove(rib)) {
                fragments.add(rib);
            }
        }
    }

    private Stream<RibComponents.Rib> ofSide(boolean left) {
        return ribs.stream().filter(rib -> isLeft(rib) == left);
    }

    private boolean isLeft(RibComponents.Rib rib) {
        return rib.centre[0] > middle;
    }

    /** The two lowest ribs of a side at the spine from below, or the one that there is. */
    private List<Ending> lowest(boolean left) {
        return ofSide(left)
                .map(rib -> new Ending(rib, VertebraHeights.vertebralEnd(s, rib, middle)))
                .filter(rib -> !rib.end.isCut())
                .sorted(Comparator.comparingDouble(rib -> rib.end.z()))
                .limit(2)
                .toList();
    }

    private boolean isLast(RibComponents.Rib part, List<Ending> above) {
        VertebralEnd end = VertebraHeights.vertebralEnd(s, part, middle);
        double below = above.get(0).end.z() - end.z();
        double length = CutRibCount.length(s, part.voxels);
        double thickness = Math.sqrt(part.voxels.size() * s.grid().voxelVolume() / length);
        return end.isWhole()
                && below > LEAST_BELOW_MM
                && below < MOST_BELOW_MM
                && length > Math.max(LEAST_LENGTH_MM, LONG * thickness)
                && mayBeTwelfth(end.z(), above);
    }

    private boolean mayBeTwelfth(double z, List<Ending> above) {
        VertebraHeights vertebrae = new VertebraHeights(s);
        return vertebrae.areShown()
                ? vertebrae.isAboveLumbar(z)
                : above.size() < 2 || !CutRibCount.isTwelfth(s, above.get(0).rib.voxels, above.get(1).rib.voxels);
    }
}
