package org.phrenic.patient.numbering;

import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.engine.math.OrderStatistic;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.Segmentation;

/**
 * Sides of connected ribs. The side is that of the label, or the other one if the rib lies among the ribs of that side,
 * as where a segmentation confuses right and left in some of them. Where labels name no side it is that of the median
 * plane.
 */
final class RibSides {
    /** A rib is of the other side if that side's median is nearer than this share of the distance to its own. */
    private static final double NEARER = 0.5;
    /** Distance of the medial ends of ribs from the median plane, mm. */
    private static final double BESIDE_MM = 15;
    /**
     * Mean share of the shorter one's breadth that ribs of two groups have in common from which on they are of one
     * side: ribs of one side all begin at the spine, those of two lie beside each other.
     */
    private static final double ONE_SIDE = 0.25;

    /** Distance of two ribs over the median distance of neighbours, below which no rib is missing between them. */
    private static final double NEIGHBOURS = 1.5;

    private final Segmentation s;
    private final List<RibComponents.Rib> ribs;
    private final double medianRight;
    private final double medianLeft;

    RibSides(Segmentation s, List<RibComponents.Rib> ribs) {
        this.s = s;
        this.ribs = ribs;
        medianRight = median(Side.RIGHT);
        medianLeft = median(Side.LEFT);
    }

    /**
     * Size of the usual part, in voxels: of the median one, or the twelfth of many, of those that are no specks beside
     * the parts that have half of all voxels.
     *
     * @param parts the largest first
     * @param speck size of a speck over that of the smallest of these parts
     */
    static int usualSize(List<RibComponents.Rib> parts, double speck) {
        long total = parts.stream().mapToLong(part -> part.voxels.size()).sum();
        long sum = 0;
        int half = 0;
        for (int i = 0; i < parts.size() && 2 * sum < total; i++) {
            half = parts.get(i).voxels.size();
            sum += half;
        }
        double least = speck * half;
        int[] sizes = parts.stream()
                .mapToInt(part -> part.voxels.size())
                .filter(size -> size >= least)
                .toArray();
        return sizes.length == 0 ? 0 : sizes[Math.min(sizes.length / 2, 11)];
    }

    /** Median x of the centres of the ribs whose label names a side, mm; NaN if there is none. */
    private double median(Side side) {
        double[] x = ribs.stream()
                .filter(rib -> labelled(rib).filter(side::equals).isPresent())
                .mapToDouble(rib -> rib.centre[0])
                .sorted()
                .toArray();
        return x.length == 0 ? Double.NaN : x[x.length / 2];
    }

    private Optional<Side> labelled(RibComponents.Rib rib) {
        String name = s.names().get(rib.dominantSegment() - 1);
        return switch (name) {
            case LabelTable.RIGHT_RIBS -> Optional.of(Side.RIGHT);
            case LabelTable.LEFT_RIBS -> Optional.of(Side.LEFT);
            default ->
                StructureName.parse(name)
                        .map(StructureName::side)
                        .filter(side -> side == Side.RIGHT || side == Side.LEFT);
        };
    }

    /** The side of a rib; empty if its label names none. */
    private Optional<Side> of(RibComponents.Rib rib) {
        return labelled(rib).map(side -> isMisplaced(rib, side) ? other(side) : side);
    }

    /** The side of a rib: that of its label, or where it lies. */
    Side of(RibComponents.Rib rib, double middle) {
        return of(rib).orElse(rib.centre[0] < middle ? Side.RIGHT : Side.LEFT);
    }

    /**
     * Where the median plane lies, mm: half way between the medial ends of right and left ribs, or beside those of one
     * side. Where labels name no side it is that of the spine or the sternum, or lies between ribs of two sides. Empty
     * if nothing tells it.
     */
    OptionalDouble middle() {
        // The x axis points to the patient's left.
        OptionalDouble right = across(Side.RIGHT).max();
        OptionalDouble left = across(Side.LEFT).min();
        if (right.isPresent() && left.isPresent()) {
            return OptionalDouble.of(0.5 * (right.getAsDouble() + left.getAsDouble()));
        }
        if (right.isPresent()) {
            return OptionalDouble.of(right.getAsDouble() + BESIDE_MM);
        }
        if (left.isPresent()) {
            return OptionalDouble.of(left.getAsDouble() - BESIDE_MM);
        }
        OptionalDouble spine = mean(name -> name.equals(LabelTable.SPINE) || isOfKind(name, StructureKind.VERTEBRA));
        OptionalDouble trunk = spine.isPresent() ? spine : mean(name -> isOfKind(name, StructureKind.STERNUM));
        return trunk.isPresent() ? trunk : between();
    }

    private static boolean isOfKind(String name, StructureKind kind) {
        return StructureName.parse(name).filter(n -> n.kind() == kind).isPresent();
    }

    /** x of all voxels of the ribs whose label names a side, mm. */
    private DoubleStream across(Side side) {
        return ribs.stream()
                .filter(rib -> of(rib).filter(side::equals).isPresent())
                .flatMapToDouble(this::across);
    }

    private DoubleStream across(RibComponents.Rib rib) {
        return IntStream.range(0, rib.voxels.size()).mapToDouble(i -> s.coordinate(rib.voxels.get(i), 0));
    }

    /** Mean x of the voxels of some structures, mm; empty if there are none. */
    private OptionalDouble mean(Predicate<String> structures) {
        boolean[] counts = new boolean[s.names().size() + 1];
        s.names().forEach(name -> counts[s.find(name)] = structures.test(name));
        return IntStream.range(0, s.voxels().length)
                .filter(v -> counts[s.segmentAt(v)])
                .mapToDouble(v -> s.coordinate(v, 0))
                .average();
    }

    /** The middle of the widest gap between the centres of ribs, mm; empty if those of its two sides overlap. */
    private OptionalDouble between() {
        List<RibComponents.Rib> sorted = ribs.stream()
                .sorted(Comparator.comparingDouble(rib -> rib.centre[0]))
                .toList();
        OptionalInt widest = IntStream.range(1, sorted.size())
                .boxed()
                .max(Comparator.comparingDouble(i -> sorted.get(i).centre[0] - sorted.get(i - 1).centre[0]))
                .stream()
                .mapToInt(i -> i)
                .findFirst();
        if (widest.isEmpty()) {
            return OptionalDouble.empty();
        }
        int first = widest.getAsInt();
        List<DoubleSummaryStatistics> breadths =
                sorted.stream().map(rib -> across(rib).summaryStatistics()).toList();
        double common = breadths.subList(0, first).stream()
                .flatMapToDouble(right ->
                        breadths.subList(first, breadths.size()).stream().mapToDouble(left -> commonShare(right, left)))
                .average()
                .orElseThrow();
        return common > ONE_SIDE
                ? OptionalDouble.empty()
                : OptionalDouble.of(0.5 * (sorted.get(first - 1).centre[0] + sorted.get(first).centre[0]));
    }

    /** Length that two stretches have in common over that of the shorter one. */
    private static double commonShare(DoubleSummaryStatistics a, DoubleSummaryStatistics b) {
        double common = Math.min(a.getMax(), b.getMax()) - Math.max(a.getMin(), b.getMin());
        double shorter = Math.min(a.getMax() - a.getMin(), b.getMax() - b.getMin());
        return shorter > 0 ? Math.max(0, common) / shorter : 0;
    }

    private static Side other(Side side) {
        return side == Side.RIGHT ? Side.LEFT : Side.RIGHT;
    }

    /** Whether a rib lies among those of the other side. NaN compares false. */
    private boolean isMisplaced(RibComponents.Rib rib, Side side) {
        double toRight = Math.abs(rib.centre[0] - medianRight);
        double toLeft = Math.abs(rib.centre[0] - medianLeft);
        return side == Side.RIGHT ? toLeft < NEARER * toRight : toRight < NEARER * toLeft;
    }

    /** What contradicts the numbers or sides of labels, one phrase; empty if nothing does. */
    Optional<String> contradiction() {
        return ribs.stream()
                .filter(rib ->
                        labelled(rib).filter(side -> isMisplaced(rib, side)).isPresent())
                .findFirst()
                .map(rib -> "label " + label(s, rib.dominantSegment()) + " names a rib of the other side")
                .or(() ->
                        slip(Side.RIGHT).or(() -> slip(Side.LEFT)).filter(slip -> new VertebraHeights(s).showThorax()));
    }

    /** Two ribs of a side whose labels leave out a number, though they are as near to each other as neighbours. */
    private Optional<String> slip(Side side) {
        TreeMap<Integer, RibComponents.Rib> byLevel = new TreeMap<>();
        ribs.stream().filter(rib -> of(rib).filter(side::equals).isPresent()).forEach(rib -> StructureName.parse(
                        s.names().get(rib.dominantSegment() - 1))
                .filter(name -> name.kind() == StructureKind.RIB)
                .ifPresent(
                        name -> byLevel.merge(name.level(), rib, (a, b) -> a.voxels.size() < b.voxels.size() ? b : a)));
        double[] steps = byLevel.keySet().stream()
                .filter(level -> byLevel.containsKey(level + 1))
                .mapToDouble(level -> byLevel.get(level).heightAbove(byLevel.get(level + 1)))
                .toArray();
        return byLevel.keySet().stream()
                .filter(level -> !byLevel.containsKey(level + 1) && byLevel.containsKey(level + 2))
                .filter(level -> byLevel.get(level).heightAbove(byLevel.get(level + 2))
                        < NEIGHBOURS * OrderStatistic.median(steps))
                .findFirst()
                .map(level -> "labels " + label(s, byLevel.get(level).dominantSegment()) + " and "
                        + label(s, byLevel.get(level + 2).dominantSegment())
                        + " leave out a number, though no rib is missing between them");
    }

    /** The first label of a segment. */
    static int label(Segmentation s, int segment) {
        return s.labels(s.names().get(segment - 1)).get(0);
    }
}
