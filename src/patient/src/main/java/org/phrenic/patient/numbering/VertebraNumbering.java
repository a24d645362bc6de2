package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.segmentation.LungPieces.LungVoxels;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.Specks;

/**
 * Numbers of vertebrae that are one off those of the ribs, a frequent error of segmentations. It is seen in the lower
 * ribs: how far the vertebral end of a rib lies from the vertebra of its number, in parts of the distance of vertebrae.
 * The ribs are right if all twelve of a side are there, if the scan cuts off the first ones and the twelfth is as short
 * as a last rib ({@link CutRibCount}), or if the first is as short as a first rib and ends at the top of the lung. Then
 * the vertebrae are numbered anew, else the ribs. Where the first ribs have the number 2, ribs and vertebrae are
 * numbered one lower. Two vertebrae under one label are seen by their height: the numbers on one side of them are one
 * off, and they are parted.
 */
final class VertebraNumbering {
    private static final String LEFT_OUT = "; what lies above vertebra_C1 then is left out";

    private static final StructureName NONE = new StructureName(StructureKind.OTHER, 0, Side.MIDLINE);

    private final Segmentation s;
    /** Name of each segment. */
    private final StructureName[] names;

    private final RibDeviations ribs;
    private final VertebraHeights height;
    /** Which segments are shown by more than specks. */
    private final boolean[] isShown;

    private VertebraNumbering(Segmentation s) {
        this.s = s;
        names = names(s);
        Specks specks = Specks.ofBones(s);
        ribs = new RibDeviations(s, specks);
        height = new VertebraHeights(s, specks);
        isShown = new boolean[names.length];
        for (int v = 0; v < s.voxels().length; v++) {
            isShown[s.segmentAt(v)] |= !specks.contain(v);
        }
    }

    /** Name of each segment, from the background on. */
    static StructureName[] names(Segmentation s) {
        return Stream.concat(Stream.of(NONE), s.names().stream().map(name -> StructureName.parse(name)
                        .orElse(NONE)))
                .toArray(StructureName[]::new);
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
            shift(-1, true, place -> true);
            return Optional.of(
                    "the highest ribs have the number 2, but are as short as the first ones and end at the top"
                            + " of the lungs: ribs and vertebrae are numbered one lower");
        }
        Optional<String> parted = partDouble();
        if (parted.isPresent()) {
            return parted;
        }
        int slip = ribs.slip(height);
        if (slip == 0) {
            return Optional.empty();
        }
        String where = slip > 0 ? "above" : "below";
        if (!ribsAreRight(slip)) {
            return Optional.of(renumbered("ribs, whose vertebrae lie one " + where + " their numbers"));
        }
        String beyond = shift(-slip, false, place -> true) ? LEFT_OUT : "";
        return Optional.of("the vertebrae lie one " + where + " the ribs of their numbers: they are numbered anew, "
                + (slip > 0 ? "vertebra_L01 is vertebra_T12" : "vertebra_T12 is vertebra_L01") + " now" + beyond);
    }

    /** Numbers the ribs anew, unless they hang together or are too many: then all keep their numbers. */
    private String renumbered(String found) {
        byte[] before = s.voxels().clone();
        try {
            return RibNumbering.renumber(s, found);
        } catch (BadInputException problem) {
            System.arraycopy(before, 0, s.voxels(), 0, before.length);
            return problem.getMessage() + "; ribs and vertebrae keep the numbers of their labels";
        }
    }

    /**
     * Whether the first ribs have the number 2, as where a spine is numbered from below that has a vertebra more or
     * less than usual: nothing has the number 1, no neck is labelled, and the ribs of number 2 on both sides, of which
     * the scan cuts nothing off, are first ones beside those of number 3.
     */
    private boolean beginsWithSecond() {
        boolean hasFirst = IntStream.range(1, names.length)
                .filter(segment -> isShown[segment] && names[segment].level() <= 1)
                .anyMatch(segment ->
                        names[segment].kind() == StructureKind.RIB || names[segment].kind() == StructureKind.VERTEBRA);
        boolean hasNeck =
                s.names().stream().filter(name -> isShown[s.find(name)]).anyMatch(SpineNames::isOfNeck);
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

    /**
     * Numbers anew what lies above or below two vertebrae under one label, if it is one off its ribs, and parts them.
     *
     * @return a note if it does
     */
    private Optional<String> partDouble() {
        for (int level = RibDeviations.FIRST_ABOVE + 1; level <= StructureName.FIRST_LUMBAR; level++) {
            if (height.isDouble(level)) {
                boolean above = isOff(RibDeviations.FIRST_ABOVE, level - 1, 1)
                        && ribs.off(height, level + 1, RibNumbering.RIBS) == 0;
                boolean below = ribs.off(height, RibDeviations.FIRST_ABOVE, level - 1) == 0
                        && isOff(level + 1, RibNumbering.RIBS, -1);
                if (above || below) {
                    return Optional.of(part(SpineNames.place(level), above));
                }
            }
        }
        return Optional.empty();
    }

    private boolean isOff(int from, int to, int by) {
        return ribs.slip(height, from, to).equals(OptionalInt.of(by));
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
        boolean leftOut = shift(upper ? -1 : 1, false, at -> upper ? at < place : at > place);
        s.write(half, s.segment(other));
        s.setLabels(other, s.labels(name));
        String where = upper ? "above" : "below";
        return name + " is as tall as two vertebrae, and those " + where + " it lie one " + where
                + " the ribs of their numbers: they are numbered anew, and it is parted at half its height into " + name
                + " and " + other + (leftOut ? LEFT_OUT : "");
    }

    /** Whether the ribs tell that the vertebrae are so many off: the first ribs only with those up to the seventh. */
    private boolean ribsAreRight(int slip) {
        boolean upperAlike = ribs.off(height, 2, RibDeviations.FIRST - 1) == slip;
        boolean cutAbove = ribs.areCutAbove();
        return Stream.of(Side.RIGHT, Side.LEFT)
                .anyMatch(side -> IntStream.rangeClosed(1, RibNumbering.RIBS).allMatch(n -> ribs.rib(n, side) > 0)
                        || (cutAbove && showsTwelfth(side))
                        || (upperAlike && isFirst(1, side)));
    }

    /** Whether the rib with the number twelve is shown to its tip and as short as a twelfth. */
    private boolean showsTwelfth(Side side) {
        int last = ribs.rib(RibNumbering.RIBS, side);
        int above = ribs.rib(RibNumbering.RIBS - 1, side);
        boolean shown = last > 0 && above > 0 && ((ribs.ends(last) | ribs.ends(above)) & s.endsToward(false)) == 0;
        return shown && CutRibCount.isTwelfth(s, ribs.voxels(last), ribs.voxels(above));
    }

    /**
     * Gives each vertebra the name of the one so many below it, and so each disc; what is beyond the fifth lumbar
     * vertebra is sacral, what is above the first cervical one becomes background.
     *
     * @param all whether ribs, their cartilages and the first sacral vertebra go with them; cartilages of which there
     *     is a first one stay
     * @param moved which vertebrae and discs, by their place from the top
     * @return whether a vertebra or disc becomes background
     */
    private boolean shift(int down, boolean all, IntPredicate moved) {
        boolean leftOut = false;
        int[] counts = s.counts();
        boolean cartilagesStay = IntStream.range(1, names.length)
                .anyMatch(i ->
                        counts[i] > 0 && names[i].kind() == StructureKind.COSTAL_CARTILAGE && names[i].level() == 1);
        byte[] segment = new byte[s.names().size() + 1];
        TreeMap<String, List<Integer>> labels = new TreeMap<>();
        for (int i = 1; i < segment.length; i++) {
            segment[i] = (byte) i;
        }
        for (String name : List.copyOf(s.names())) {
            int place = SpineNames.place(name);
            boolean ofSpine = place >= 0;
            boolean moves = !ofSpine || moved.test(place);
            String now = !moves ? name : all ? allShifted(name, down, cartilagesStay) : SpineNames.below(name, down);
            if (ofSpine && moves && place + 2 * down < 0) {
                segment[s.find(name)] = 0;
                leftOut = true;
            } else if (ofSpine || !now.equals(name)) {
                boolean joins = now.equals(SpineNames.SACRAL) && s.find(now) > 0;
                labels.computeIfAbsent(now, n -> new ArrayList<>(joins ? s.labels(n) : List.of()))
                        .addAll(s.labels(name));
                segment[s.find(name)] = (byte) s.segment(now);
            }
        }
        for (int v = 0; v < s.voxels().length; v++) {
            s.voxels()[v] = segment[s.segmentAt(v)];
        }
        labels.forEach(s::setLabels);
        return leftOut;
    }

    private static String allShifted(String name, int down, boolean cartilagesStay) {
        StructureName parsed = StructureName.parse(name).orElse(NONE);
        boolean cartilage = parsed.kind() == StructureKind.COSTAL_CARTILAGE && !cartilagesStay;
        if (parsed.kind() == StructureKind.RIB || cartilage) {
            int level = Math.max(1, parsed.level() + down);
            return name.replaceFirst("\\d+", String.format(Locale.ROOT, "%02d", level));
        }
        return name.equals(SpineNames.SACRAL) && down < 0
                ? SpineNames.at(SpineNames.place(StructureName.FIRST_LUMBAR + 5 + down))
                : SpineNames.below(name, down);
    }
}
