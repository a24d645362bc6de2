package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.label.SpineNames;
import org.phrenic.patient.segmentation.LungPieces.LungVoxels;
import org.phrenic.patient.segmentation.Segmentation;

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
    /** First rib that is looked at, but for those above two vertebrae under one label. */
    private static final int FIRST = 7;

    private static final int FIRST_ABOVE = 2;
    /**
     * Height of the vertebra above the vertebral end of ribs 7 to 12, in distances of vertebrae: means of two trunks,
     * the scanned man and the virtual woman, each within 0.25 of it.
     */
    private static final double[] USUAL = {-0.47, -0.42, -0.33, -0.25, 0.05, 0.5};

    /** The same of ribs 2 to 6 in these and a trunk at inspiration, each within 0.55. */
    private static final double USUAL_ABOVE = -0.5;

    /**
     * Distance from the median plane to which ends of ribs are continued, mm: about that of the transverse processes.
     * In these trunks ribs 7 to 11 end 12 to 27 mm from it, ribs 12 at 35 mm, and are nearly level up to there.
     */
    private static final double USUAL_END_MM = 30;
    /**
     * Fall of ribs 7 to 12 beyond that distance, mm for each mm away from the median plane. Between 30 and 60 mm it is
     * 0.55 in the virtual woman and 0.74 in the scanned man; ribs of other bodies are flatter, with 0.47 (the virtual
     * man), 0.46 (a scanned trunk), 0.1 and 0.2 (two people at inspiration). With 0.5, no right numbers are taken for
     * wrong in 60 scans of the four with a spine, in which ribs end up to 20 mm beside it and which lean by up to 11
     * degrees; with 0.6 one is, with 0 eleven are.
     */
    private static final double FALL = 0.5;

    private static final int LEAST_RIBS = 4;
    /** Numbers are one off if the median of the ribs deviates by so much, and most ribs are near to it. */
    private static final double LEAST_DEVIATION = 0.65;

    private static final double MOST_DEVIATION = 1.35;
    private static final double SCATTER = 0.5;
    private static final double MOST = 0.75;
    /** Least voxels of a rib over those of the median rib; the shortest ribs 12 have 0.03. */
    private static final double LEAST_SHARE = 0.02;

    private static final String LEFT_OUT = "; what lies above vertebra_C1 then is left out";

    private static final StructureName NONE = new StructureName(StructureKind.OTHER, 0, Side.MIDLINE);

    private final Segmentation s;
    /** Name of each segment. */
    private final StructureName[] names;
    /** Voxels of each rib, by segment. */
    private final TreeMap<Integer, IntList> ribs = new TreeMap<>();
    /** The ends of the scan that each rib reaches, as {@link Segmentation#ends}. */
    private final TreeMap<Integer, Integer> ends = new TreeMap<>();

    private VertebraNumbering(Segmentation s) {
        this.s = s;
        names = Stream.concat(Stream.of(NONE), s.names().stream().map(name -> StructureName.parse(name)
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
        double sumX = 0;
        int vertebral = 0;
        for (int v = 0; v < s.voxels().length; v++) {
            int segment = s.segmentAt(v);
            if (names[segment].kind() == StructureKind.VERTEBRA) {
                sumX += s.coordinate(v, 0);
                vertebral++;
            } else if (names[segment].kind() == StructureKind.RIB) {
                ribs.computeIfAbsent(segment, rib -> new IntList()).add(v);
                ends.merge(segment, s.ends(v), (a, b) -> a | b);
            }
        }
        if (vertebral == 0 || ribs.isEmpty()) {
            return Optional.empty();
        }
        if (beginsWithSecond(sumX / vertebral)) {
            shift(-1, true, place -> true);
            return Optional.of(
                    "the highest ribs have the number 2, but are as short as the first ones and end at the top"
                            + " of the lungs: ribs and vertebrae are numbered one lower");
        }
        Optional<String> parted = partDouble(sumX / vertebral);
        if (parted.isPresent()) {
            return parted;
        }
        int slip = slip(sumX / vertebral);
        if (slip == 0) {
            return Optional.empty();
        }
        String where = slip > 0 ? "above" : "below";
        if (!ribsAreRight(sumX / vertebral, slip)) {
            return Optional.of(RibNumbering.renumber(s, "ribs, whose vertebrae lie one " + where + " their numbers"));
        }
        String beyond = shift(-slip, false, place -> true) ? LEFT_OUT : "";
        return Optional.of("the vertebrae lie one " + where + " the ribs of their numbers: they are numbered anew, "
                + (slip > 0 ? "vertebra_L01 is vertebra_T12" : "vertebra_T12 is vertebra_L01") + " now" + beyond);
    }

    /**
     * Whether the first ribs have the number 2, as where a spine is numbered from below that has a vertebra more or
     * less than usual: nothing has the number 1, no neck is labelled, and the ribs of number 2 on both sides, of which
     * the scan cuts nothing off, are first ones beside those of number 3.
     */
    private boolean beginsWithSecond(double middle) {
        int[] counts = s.counts();
        boolean hasFirst = IntStream.range(1, names.length)
                .filter(segment -> counts[segment] > 0 && names[segment].level() <= 1)
                .anyMatch(segment ->
                        names[segment].kind() == StructureKind.RIB || names[segment].kind() == StructureKind.VERTEBRA);
        boolean hasNeck =
                s.names().stream().filter(name -> counts[s.find(name)] > 0).anyMatch(SpineNames::isOfNeck);
        return !hasFirst && !hasNeck && Stream.of(Side.RIGHT, Side.LEFT).allMatch(side -> isFirst(2, side, middle));
    }

    /** Whether the rib of a number is a first one beside that of the next, and the scan cuts nothing off the two. */
    private boolean isFirst(int number, Side side, double middle) {
        int rib = rib(number, side);
        int next = rib(number + 1, side);
        return rib > 0
                && next > 0
                && (ends.get(rib) | ends.get(next)) == 0
                && isFirst(ribs.get(rib), ribs.get(next), middle, side);
    }

    private boolean isFirst(IntList rib, IntList next, double middle, Side side) {
        Optional<LungVoxels> lung = LungVoxels.of(s, side == Side.RIGHT ? "lung_R" : "lung_L");
        OptionalDouble end = vertebralEnd(rib, middle);
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
    private Optional<String> partDouble(double middle) {
        VertebraHeights height = new VertebraHeights(s);
        for (int level = FIRST_ABOVE + 1; level <= StructureName.FIRST_LUMBAR; level++) {
            if (height.isDouble(level)) {
                long above = off(deviations(height, middle, FIRST_ABOVE, level - 1));
                long below = off(deviations(height, middle, level + 1, RibNumbering.RIBS));
                if ((above == 1 && below == 0) || (above == 0 && below == -1)) {
                    return Optional.of(part(SpineNames.place(level), above == 1));
                }
            }
        }
        return Optional.empty();
    }

    /** By how many numbers so many ribs are off; 0 for less than two. */
    private static long off(double[] deviations) {
        return deviations.length < 2 ? 0 : Math.round(median(deviations));
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

    private static double median(double[] sorted) {
        return sorted[sorted.length / 2];
    }

    /**
     * How far the ribs of these numbers deviate from the vertebrae of theirs, in distances of vertebrae, in ascending
     * order.
     */
    private double[] deviations(VertebraHeights height, double middle, int from, int to) {
        double spacing = (height.at(FIRST) - height.at(RibNumbering.RIBS)) / (RibNumbering.RIBS - FIRST);
        return ribs.entrySet().stream()
                .filter(rib -> names[rib.getKey()].level() >= from && names[rib.getKey()].level() <= to)
                .flatMapToDouble(rib -> {
                    int number = names[rib.getKey()].level();
                    double usual = number < FIRST ? USUAL_ABOVE : USUAL[number - FIRST];
                    OptionalDouble end = vertebralEnd(rib.getValue(), middle);
                    return end.stream().map(z -> (height.at(number) - z) / spacing - usual);
                })
                .sorted()
                .toArray();
    }

    /** 1 if the vertebrae lie one above the ribs of their numbers, -1 if one below, otherwise 0. */
    private int slip(double middle) {
        double[] deviation = deviations(new VertebraHeights(s), middle, FIRST, RibNumbering.RIBS);
        if (deviation.length < LEAST_RIBS) {
            return 0;
        }
        double median = median(deviation);
        long near = Arrays.stream(deviation)
                .filter(d -> Math.abs(d - median) < SCATTER)
                .count();
        boolean off = Math.abs(median) > LEAST_DEVIATION && Math.abs(median) < MOST_DEVIATION;
        return off && near >= MOST * deviation.length ? (int) Math.signum(median) : 0;
    }

    /**
     * Height of the end of a rib toward the spine, mm, continued to the usual distance from the median plane; empty if
     * it is far from it or the scan ends there.
     */
    private OptionalDouble vertebralEnd(IntList voxels, double middle) {
        double y = 0;
        for (int i = 0; i < voxels.size(); i++) {
            y += s.coordinate(voxels.get(i), 1) / voxels.size();
        }
        List<double[]> posterior = VertebraHeights.posterior(s, voxels, y, middle);
        posterior.forEach(p -> p[1] += FALL * Math.max(0, p[0] - USUAL_END_MM));
        return VertebraHeights.isFarFromSpine(posterior) || VertebraHeights.isEndCut(posterior, voxels.size())
                ? OptionalDouble.empty()
                : VertebraHeights.endHeight(posterior, voxels.size());
    }

    /** Whether the ribs tell that the vertebrae are so many off: the first ribs only with those up to the seventh. */
    private boolean ribsAreRight(double middle, int slip) {
        boolean upperAlike = off(deviations(new VertebraHeights(s), middle, 2, FIRST - 1)) == slip;
        boolean cutAbove = ends.values().stream().anyMatch(at -> (at & s.endsToward(true)) != 0);
        return Stream.of(Side.RIGHT, Side.LEFT)
                .anyMatch(side -> IntStream.rangeClosed(1, RibNumbering.RIBS).allMatch(n -> rib(n, side) > 0)
                        || (cutAbove && showsTwelfth(side))
                        || (upperAlike && isFirst(1, side, middle)));
    }

    /** Segment of a rib; 0 if it is not there or no more than a speck. */
    private int rib(int number, Side side) {
        int[] sizes = ribs.values().stream().mapToInt(IntList::size).sorted().toArray();
        double least = LEAST_SHARE * sizes[sizes.length / 2];
        return ribs.keySet().stream()
                .filter(segment -> names[segment].level() == number && names[segment].side() == side)
                .filter(segment -> ribs.get(segment).size() >= least)
                .findFirst()
                .orElse(0);
    }

    /** Whether the rib with the number twelve is shown to its tip and as short as a twelfth. */
    private boolean showsTwelfth(Side side) {
        int last = rib(RibNumbering.RIBS, side);
        int above = rib(RibNumbering.RIBS - 1, side);
        boolean shown = last > 0 && above > 0 && ((ends.get(last) | ends.get(above)) & s.endsToward(false)) == 0;
        return shown && CutRibCount.isTwelfth(s, ribs.get(last), ribs.get(above));
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
