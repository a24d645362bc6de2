package org.phrenic.patient.label;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * How well the numbers of a tool fit the labels of a volume.
 *
 * @param structures structure by label, of the labels that the volume has
 * @param places whether these labels lie where their structures lie
 * @param volumes whether they are as large as their structures, one over another
 * @param lungs whether they may be lungs, if lungs are all that they are
 * @param unknown number of labels that the tool does not have
 * @param lead comparisons by which it fits better than any table that makes other structures of the labels
 */
record NumberMatch(
        NumberTable table,
        Map<Integer, String> structures,
        LabelPlaces places,
        LabelVolumes volumes,
        boolean lungs,
        int unknown,
        double lead) {
    /** Least number of comparisons, if the volume does not have exactly the labels of the table nor labels from 1. */
    private static final int ENOUGH = 3;
    /** Least lead before other tables in this case. */
    private static final double CLEAR = 2;
    /** Least number of comparisons otherwise: two lungs give one of places and one of volumes. */
    private static final int ENOUGH_OF_ALL = 2;
    /** Greatest number of labels that the tool does not have, and share of those that it has: some may be added. */
    private static final int MOST_UNKNOWN = 3;

    private static final double MOST_UNKNOWN_SHARE = 0.25;
    /** Labels of the table that may be absent for one label that it does not have. */
    private static final int UNKNOWN_WEIGHT = 3;
    /** Share of its labels from which a table is hardly longer than the volume's own numbers. */
    private static final double MOST_OF_TABLE = 0.65;
    /** Least share of the comparisons of places and volumes that hold in other axes than the stated ones, of many. */
    private static final double LEAST_IN_OTHER_AXES = 0.97;
    /** Least share of the comparisons of places that hold. */
    private static final double LEAST_OF_PLACES = 0.85;
    /** Number of comparisons of places and volumes from which some of the places may fail in labels from 1. */
    private static final int MANY = 30;
    /** Number of structures from which they may do so as well. */
    private static final int SEVERAL = 8;
    /** Number of comparisons of places that decide without volumes: organs of patients have other sizes. */
    private static final int DECISIVE = 12;
    /** Least share of the comparisons of places and volumes that hold. */
    private static final double LEAST_OF_ALL = 0.8;

    /** Positions of the labels of a volume, in sectors of those that are ribs by any table. */
    static LabelPositions positions(LabelGrid grid) {
        Set<Integer> ribs = new HashSet<>();
        NumberTable.ALL.forEach(table -> ribs.addAll(LabelPlaces.ribs(table.structures())));
        return new LabelPositions(grid, ribs);
    }

    /** The table that fits a volume best; the first one of those that fit alike. */
    static NumberMatch best(LabelPositions positions, List<NumberTable> tables) {
        List<NumberMatch> all =
                tables.stream().map(table -> of(table, positions)).toList();
        Function<LabelPlaces, Optional<BodyAxes>> stated = places -> Optional.of(BodyAxes.STATED);
        NumberMatch best = first(all, stated);
        return best.score(stated) > 0 ? best : first(all, StatedAxes::ofNumbers);
    }

    /** The version of a tool that fits a volume best, of those that may be its own if any may. */
    static NumberMatch version(LabelPositions positions, List<NumberTable> versions) {
        List<NumberTable> possible = versions.stream()
                .filter(table -> of(table, positions).isPossible())
                .toList();
        return best(positions, possible.isEmpty() ? versions : possible);
    }

    /** The table that fits a volume best in axes that the file does not state; empty if none does so clearly. */
    static Optional<NumberMatch> inOtherAxes(LabelPositions positions, List<NumberTable> tables) {
        NumberMatch best =
                first(tables.stream().map(table -> of(table, positions)).toList(), StatedAxes::ofNumbers);
        return Optional.of(best)
                .filter(match -> match.otherAxes().isPresent()
                        && match.lead >= CLEAR
                        && match.hasFewUnknown()
                        && match.share(match.otherAxes().orElseThrow()) >= LEAST_IN_OTHER_AXES);
    }

    /**
     * Whether the labels are 1, 2 and so on without a gap, and bones alone: counted from another end, or with the other
     * side first, they lie as in other axes.
     */
    boolean mayBeInAnotherOrder() {
        return isWithoutGap() && structures.values().stream().allMatch(NumberMatch::isBone);
    }

    private static boolean isBone(String structure) {
        return StructureName.parse(structure)
                .filter(name -> name.kind() == StructureKind.VERTEBRA
                        || name.kind() == StructureKind.RIB
                        || name.kind() == StructureKind.BONE)
                .isPresent();
    }

    /** Axes, other than the stated ones, in which the labels lie as their structures. */
    Optional<BodyAxes> otherAxes() {
        return StatedAxes.ofNumbers(places);
    }

    private static NumberMatch of(NumberTable table, LabelPositions positions) {
        Map<Integer, String> present = new TreeMap<>(table.structures());
        present.keySet().removeIf(label -> positions.count(label) == 0);
        int labels = (int) IntStream.rangeClosed(1, LabelGrid.MAX_LABEL)
                .filter(label -> positions.count(label) > 0)
                .count();
        return new NumberMatch(
                table,
                present,
                new LabelPlaces(positions, present, table.below()),
                LabelVolumes.of(positions, present),
                LungNumbers.arePossible(positions, present),
                labels - present.size(),
                0);
    }

    private static NumberMatch first(List<NumberMatch> all, Function<LabelPlaces, Optional<BodyAxes>> axesOf) {
        // The minimum of a stream is the first of equal ones.
        NumberMatch best = all.stream()
                .min(Comparator.comparingDouble(match -> -match.score(axesOf)))
                .orElseThrow();
        double next = all.stream()
                .filter(match -> !match.structures.equals(best.structures))
                .mapToDouble(match -> match.score(axesOf))
                .max()
                .orElse(Double.NEGATIVE_INFINITY);
        return new NumberMatch(
                best.table,
                best.structures,
                best.places,
                best.volumes,
                best.lungs,
                best.unknown,
                best.score(axesOf) - next);
    }

    /** Comparisons that hold in some axes without those that fail and without unknown labels; negative without axes. */
    private double score(Function<LabelPlaces, Optional<BodyAxes>> axesOf) {
        return axesOf.apply(places)
                .filter(places::areBones)
                .map(axes -> places.compared() * (2 * places.share(axes) - 1)
                        + 2 * volumes.holding()
                        - volumes.compared()
                        - unknown)
                .orElse(-1.0 - unknown);
    }

    /** Number of comparisons of places and volumes. */
    int compared() {
        return places.compared() + volumes.compared();
    }

    /** Whether the labels are taken for the tool's in the axes that the file states. */
    boolean fits() {
        boolean whole = unknown == 0 && structures.size() == table.structures().size();
        boolean clear = compared() >= ENOUGH && lead >= CLEAR && !isFromOne();
        return isPossible() && (whole ? compared() >= ENOUGH_OF_ALL : clear);
    }

    /** Whether the labels are taken for the tool's and are no others that lie as well where these are in people. */
    boolean contradicts(LabelGrid grid, Map<Integer, String> others) {
        return fits() && !agrees(others) && new LabelPlaces(grid, others).share() < LEAST_OF_PLACES;
    }

    /** Whether the labels are taken for the tool's, and others are the same as far as they go, but are fewer. */
    boolean tellsMoreThan(Map<Integer, String> others) {
        long known = structures.values().stream()
                .filter(structure -> !structure.startsWith(OrganNames.OTHER_PREFIX))
                .count();
        return fits() && known > others.size() && agrees(others);
    }

    private boolean agrees(Map<Integer, String> others) {
        return others.entrySet().stream()
                .allMatch(other -> other.getValue().equals(structures.getOrDefault(other.getKey(), other.getValue())));
    }

    /** Whether the labels are 1, 2 and so on without a gap, as anybody numbers a few structures, of another table. */
    private boolean isFromOne() {
        return places.compared() < DECISIVE
                && isWithoutGap()
                && (structures.size() < MOST_OF_TABLE * (table.structures().size() + UNKNOWN_WEIGHT * unknown)
                        || (compared() < MANY && structures.size() < SEVERAL && places.share() < 1));
    }

    private boolean hasFewUnknown() {
        return unknown <= Math.max(MOST_UNKNOWN, MOST_UNKNOWN_SHARE * structures.size());
    }

    /** The table whose structures lie as the labels do but for right and left ones, which are exchanged. */
    static Optional<NumberMatch> withSidesExchanged(LabelPositions positions, List<NumberTable> tables) {
        return tables.stream()
                .map(table -> of(table, positions))
                .filter(match -> match.places.compared() >= DECISIVE
                        && match.hasFewUnknown()
                        && match.places.haveSidesExchanged())
                .max(Comparator.comparingInt(match -> match.places.compared() - match.unknown));
    }

    private boolean isWithoutGap() {
        int last = structures.keySet().stream().mapToInt(label -> label).max().orElse(0);
        return last <= structures.size() + unknown;
    }

    /** Whether the comparisons are too few to tell this table from others. */
    boolean tellsTooLittle() {
        return compared() < ENOUGH || lead < CLEAR;
    }

    /** Whether the labels may be the tool's in the axes that the file states. */
    boolean isPossible() {
        return places.compared() > 0
                && lungs
                && hasFewUnknown()
                && places.areBones(BodyAxes.STATED)
                && places.share() >= LEAST_OF_PLACES
                && (places.compared() >= DECISIVE
                        || (share(BodyAxes.STATED) >= LEAST_OF_ALL && volumes.ofPeople() >= LEAST_OF_ALL));
    }

    /** Share of the comparisons of places and volumes that hold in some axes. */
    double share(BodyAxes axes) {
        return (places.compared() * places.share(axes) + volumes.holding()) / Math.max(1, compared());
    }
}
