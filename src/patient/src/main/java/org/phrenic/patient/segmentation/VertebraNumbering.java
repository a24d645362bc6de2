package org.phrenic.patient.segmentation;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.label.SpineNames;
import org.phrenic.patient.segmentation.LungPieces.LungVoxels;

/**
 * Numbers of vertebrae that are one off those of the ribs, a frequent error of segmentations. It is seen in the lower
 * ribs: how far the vertebral end of a rib lies from the vertebra of its number, in parts of the distance of vertebrae.
 * The ribs are right if all twelve of a side are there, if the scan cuts off the first ones and the twelfth is as short
 * as a last rib ({@link CutRibCount}), or if the first is as short as a first rib and ends at the top of the lung. Then
 * the vertebrae are numbered anew, else the ribs. Where the first ribs have the number 2, ribs and vertebrae are
 * numbered one lower. Faults within the spine are {@link SpineFaults}.
 */
final class VertebraNumbering {
    private static final StructureName NONE = new StructureName(StructureKind.OTHER, 0, Side.MIDLINE);

    private final Segmentation s;
    /** Name of each segment. */
    private final StructureName[] names;

    private final RibDeviations ribs;

    private VertebraNumbering(Segmentation s) {
        this.s = s;
        names = Stream.concat(Stream.of(NONE), s.names().stream().map(name -> StructureName.parse(name)
                        .orElse(NONE)))
                .toArray(StructureName[]::new);
        ribs = new RibDeviations(s, names);
    }

    /**
     * Numbers the vertebrae or the ribs anew if they are one off each other.
     *
     * @return a note if they were
     */
    static Optional<String> check(Segmentation s) {
        boolean known = s.names().stream()
                .flatMap(name -> StructureName.parse(name).stream())
                .anyMatch(name -> name.kind() == StructureKind.VERTEBRA && name.level() <= RibNumbering.RIBS);
        return known ? new VertebraNumbering(s).check() : Optional.empty();
    }

    private Optional<String> check() {
        if (!ribs.areKnown()) {
            return Optional.empty();
        }
        if (beginsWithSecond()) {
            SpineShift.shift(s, -1, true, place -> true);
            return Optional.of(
                    "the highest ribs have the number 2, but are as short as the first ones and end at the top"
                            + " of the lungs: ribs and vertebrae are numbered one lower");
        }
        Optional<String> fault = SpineFaults.mend(s, ribs);
        if (fault.isPresent()) {
            return fault;
        }
        int slip = ribs.slip();
        if (slip == 0) {
            return Optional.empty();
        }
        String where = slip > 0 ? "above" : "below";
        if (!ribsAreRight(slip)) {
            return Optional.of(
                    RibNumbering.renumber(s, "ribs, whose vertebrae lie one " + where + " their numbers", slip));
        }
        String beyond = SpineShift.shift(s, -slip, false, place -> true);
        return Optional.of("the vertebrae lie one " + where + " the ribs of their numbers: they are numbered anew, "
                + (slip > 0 ? "vertebra_L01 is vertebra_T12" : "vertebra_T12 is vertebra_L01") + " now" + beyond);
    }

    /**
     * Whether the first ribs have the number 2, as where a spine is numbered from below that has a vertebra more or
     * less than usual: nothing has the number 1, no neck is labelled, and the ribs of number 2 on both sides, of which
     * the scan cuts nothing off, are first ones beside those of number 3.
     */
    private boolean beginsWithSecond() {
        int[] counts = s.counts();
        boolean hasFirst = IntStream.range(1, names.length)
                .filter(segment -> counts[segment] > 0 && names[segment].level() <= 1)
                .anyMatch(segment ->
                        names[segment].kind() == StructureKind.RIB || names[segment].kind() == StructureKind.VERTEBRA);
        boolean hasNeck =
                s.names().stream().filter(name -> counts[s.find(name)] > 0).anyMatch(SpineNames::isOfNeck);
        return !hasFirst && !hasNeck && Stream.of(Side.RIGHT, Side.LEFT).allMatch(side -> isFirst(2, side));
    }

    /** Whether the rib of a number is a first one beside that of the next, and the scan cuts nothing off the two. */
    private boolean isFirst(int number, Side side) {
        int rib = ribs.rib(number, side);
        int next = ribs.rib(number + 1, side);
        return rib > 0
                && next > 0
                && (ribs.ends(rib) | ribs.ends(next)) == 0
                && isFirst(ribs.voxels(rib), ribs.voxels(next), side);
    }

    private boolean isFirst(IntList rib, IntList next, Side side) {
        Optional<LungVoxels> lung = LungVoxels.of(s, side == Side.RIGHT ? "lung_R" : "lung_L");
        OptionalDouble end = ribs.vertebralEnd(rib);
        return lung.isPresent()
                && end.isPresent()
                && SkeletonSplitter.isFirst(
                        CutRibCount.length(s, rib), CutRibCount.length(s, next), end.getAsDouble(), lung.get());
    }

    /** Whether the ribs tell that the vertebrae are so many off: the first ribs only with those up to the seventh. */
    private boolean ribsAreRight(int slip) {
        boolean upperAlike = ribs.off(new VertebraHeights(s), 2, RibDeviations.FIRST - 1) == slip;
        return Stream.of(Side.RIGHT, Side.LEFT)
                .anyMatch(side -> IntStream.rangeClosed(1, RibNumbering.RIBS).allMatch(n -> ribs.rib(n, side) > 0)
                        || (ribs.areCutAbove() && showsTwelfth(side))
                        || (upperAlike && isFirst(1, side)));
    }

    /** Whether the rib with the number twelve is shown to its tip and as short as a twelfth. */
    private boolean showsTwelfth(Side side) {
        int last = ribs.rib(RibNumbering.RIBS, side);
        int above = ribs.rib(RibNumbering.RIBS - 1, side);
        boolean shown = last > 0 && above > 0 && ((ribs.ends(last) | ribs.ends(above)) & s.endsToward(false)) == 0;
        return shown && CutRibCount.isTwelfth(s, ribs.voxels(last), ribs.voxels(above));
    }
}
