package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Whether labels lie where their structures lie in people: right ribs and lung to the right of the left ones, ribs and
 * vertebrae in descending order, lungs above the liver, upper lobes above lower ones, organs of the upper abdomen
 * between T7 and L4, liver to the right of the spleen and in front of great vessels, sternum and organs in front of the
 * spine, of trachea and oesophagus. Ribs are compared where both lie in one sector about the body's axis: of ribs that
 * the scan cuts off, middles tell nothing.
 */
final class LabelPlaces {
    /** Least number of voxels of a sector that counts, over that of the fullest one: the rest may be specks. */
    private static final double LEAST_SECTOR = 0.2;
    /** Least mean distance (mm) from right ribs to left ones of their levels; vertebrae stand in one column. */
    private static final double LEAST_BETWEEN_SIDES = 50;
    /** Greatest mean distance (mm) of vertebrae from their middle to a side; ribs of two sides lie farther off. */
    private static final double MOST_BESIDE_SPINE = 50;
    /** Least number of pairs of right and left structures that tell whether their names are exchanged. */
    private static final int LEAST_PAIRS = 3;
    /** Share of the comparisons along a coordinate that have to hold. */
    private static final double MOST = 0.8;

    private static final List<String> BEHIND_LIVER = List.of("aorta", "inferior_vena_cava", "organ_kidneys");
    private static final List<String> IN_FRONT_OF_SPINE =
            List.of("sternum", "sternum_manubrium", "sternum_body", "heart", "liver", "stomach");
    private static final List<String> AT_FRONT =
            List.of("sternum", "sternum_manubrium", "sternum_body", "costal_cartilages", "heart");
    private static final List<String> BEHIND_FRONT = List.of("trachea", "oesophagus", "aorta");

    /** Organs whose middles, or those of what a scan shows of them, lie below T7 and above L4. */
    private static final List<String> UPPER_ABDOMEN =
            List.of("liver", "spleen", "pancreas", "adrenal_gland_R", "adrenal_gland_L");

    private static final int T7 = 7;
    private static final int L4 = StructureName.FIRST_LUMBAR + 3;

    private final Map<String, double[]> centres = new TreeMap<>();
    /** Of each rib the sum of heights (mm) and the number of voxels in each sector. */
    private final Map<String, double[][]> ribs = new TreeMap<>();

    private final List<Relation> relations = new ArrayList<>();
    /** Those of right structures and their left counterparts. */
    private final List<Relation> pairs = new ArrayList<>();
    /** Vectors from right ribs to left ones. */
    private final List<double[]> acrossCage = new ArrayList<>();

    /** A vector between two structures of which one coordinate is positive in people. */
    private record Relation(int axis, double[] apart) {
        boolean holds(BodyAxes axes) {
            return axes.coordinate(apart, axis) > 0;
        }
    }

    /** @param structures structure by label */
    LabelPlaces(LabelGrid grid, Map<Integer, String> structures) {
        this(new LabelPositions(grid, ribs(structures)), structures, Map.of());
    }

    /**
     * @param structures structure by label
     * @param below label of the lower lobe of a lung by that of the upper one
     */
    LabelPlaces(LabelPositions positions, Map<Integer, String> structures, Map<Integer, Integer> below) {
        Map<String, Integer> voxels = new TreeMap<>();
        structures.forEach((label, structure) -> {
            int count = positions.count(label);
            if (count > 0) {
                int all = voxels.merge(structure, count, Integer::sum);
                double[] centre = centres.computeIfAbsent(structure, s -> new double[3]);
                for (int axis = 0; axis < 3; axis++) {
                    centre[axis] += (positions.centre(label)[axis] - centre[axis]) * count / all;
                }
                if (isRib(structure)) {
                    add(
                            ribs.computeIfAbsent(structure, s -> new double[LabelPositions.SECTORS][2]),
                            positions.sectors(label));
                }
            }
        });
        compare();
        below.forEach((upper, lower) -> {
            if (positions.count(upper) > 0 && positions.count(lower) > 0) {
                relations.add(new Relation(2, Vectors.subtract(positions.centre(upper), positions.centre(lower))));
            }
        });
    }

    /** Labels that are ribs. */
    static Set<Integer> ribs(Map<Integer, String> structures) {
        return structures.keySet().stream()
                .filter(label -> isRib(structures.get(label)))
                .collect(Collectors.toSet());
    }

    private static boolean isRib(String structure) {
        return isOf(structure, StructureKind.RIB);
    }

    private static void add(double[][] sum, double[][] sectors) {
        for (int sector = 0; sector < LabelPositions.SECTORS; sector++) {
            sum[sector][0] += sectors[sector][0];
            sum[sector][1] += sectors[sector][1];
        }
    }

    private static boolean isOf(String structure, StructureKind kind) {
        return StructureName.parse(structure).filter(n -> n.kind() == kind).isPresent();
    }

    /** Mean height of one rib above another where both lie in one sector; empty if they share none. */
    private OptionalDouble heightAbove(String rib, String other) {
        double[][] one = ribs.get(rib);
        double[][] two = ribs.get(other);
        double least = LEAST_SECTOR * most(one);
        double leastOfOther = LEAST_SECTOR * most(two);
        return IntStream.range(0, LabelPositions.SECTORS)
                .filter(i -> one[i][1] > least && two[i][1] > leastOfOther)
                .mapToDouble(i -> one[i][0] / one[i][1] - two[i][0] / two[i][1])
                .average();
    }

    private static double most(double[][] rib) {
        return Arrays.stream(rib).mapToDouble(sector -> sector[1]).max().orElse(0);
    }

    private void compare() {
        List<StructureName> names = new ArrayList<>();
        List<String> structures = new ArrayList<>();
        NavigableMap<Integer, String> vertebrae = new TreeMap<>();
        centres.keySet().forEach(structure -> StructureName.parse(structure).ifPresent(name -> {
            structures.add(structure);
            names.add(name);
            if (name.kind() == StructureKind.VERTEBRA) {
                vertebrae.put(name.level(), structure);
            }
        }));
        for (int a = 0; a < names.size(); a++) {
            for (int b = 0; b < names.size(); b++) {
                comparePair(structures.get(a), names.get(a), structures.get(b), names.get(b));
            }
        }
        expect("liver", "spleen", 0);
        expect("liver", "lung_R", 2);
        expect("liver", LabelTable.LUNGS, 2);
        expect("spleen", "lung_L", 2);
        expectPair("kidney_R", "kidney_L");
        expectPair("adrenal_gland_R", "adrenal_gland_L");
        expect("liver", "stomach", 0);
        expect("liver", LabelTable.LUNGS, 0);
        expect("liver", "organ_kidneys", 0);
        expect("organ_kidneys", LabelTable.LUNGS, 2);
        expect("urinary_bladder", "organ_kidneys", 2);
        expect("urinary_bladder", "organ_kidneys", 1);
        BEHIND_LIVER.forEach(behind -> expect("liver", behind, 1));
        expect("gallbladder", "stomach", 0);
        expect("gallbladder", "spleen", 0);
        expect("urinary_bladder", "heart", 2);
        expect("urinary_bladder", "liver", 2);
        AT_FRONT.forEach(front -> BEHIND_FRONT.forEach(behind -> expect(front, behind, 1)));
        Optional.ofNullable(vertebrae.floorEntry(T7))
                .ifPresent(above -> UPPER_ABDOMEN.forEach(organ -> expect(organ, above.getValue(), 2)));
        Optional.ofNullable(vertebrae.ceilingEntry(L4))
                .ifPresent(below -> UPPER_ABDOMEN.forEach(organ -> expect(below.getValue(), organ, 2)));
        spine().ifPresent(spine -> IN_FRONT_OF_SPINE.stream()
                .map(centres::get)
                .filter(Objects::nonNull)
                .forEach(front -> relations.add(new Relation(1, Vectors.subtract(spine, front)))));
    }

    private void comparePair(String one, StructureName name, String other, StructureName otherName) {
        double[] apart = Vectors.subtract(centres.get(other), centres.get(one));
        boolean sided = name.side() == Side.RIGHT && otherName.side() == Side.LEFT;
        if (sided
                && name.kind() == otherName.kind()
                && name.level() == otherName.level()
                && !name.kind().isNamed()) {
            addPair(apart);
            if (name.kind() == StructureKind.RIB) {
                acrossCage.add(apart);
            }
        }
        boolean next = name.kind() == otherName.kind()
                && name.side() == otherName.side()
                && otherName.level() == name.level() + 1;
        if (next && name.kind() == StructureKind.VERTEBRA) {
            relations.add(new Relation(2, Vectors.subtract(centres.get(one), centres.get(other))));
        } else if (next && name.kind() == StructureKind.RIB) {
            heightAbove(one, other)
                    .ifPresent(above -> relations.add(new Relation(2, new double[] {-apart[0], -apart[1], above})));
        }
    }

    private List<double[]> vertebrae() {
        return centres.entrySet().stream()
                .filter(entry -> isOf(entry.getKey(), StructureKind.VERTEBRA))
                .map(Map.Entry::getValue)
                .toList();
    }

    /** Whether ribs of two sides lie as far apart as in people, and vertebrae in one column. */
    boolean areBones(BodyAxes axes) {
        boolean cage = acrossCage.stream()
                        .mapToDouble(apart -> axes.coordinate(apart, 0))
                        .average()
                        .orElse(Double.POSITIVE_INFINITY)
                > LEAST_BETWEEN_SIDES;
        double beside = spine().map(middle -> vertebrae().stream()
                        .mapToDouble(centre -> Math.abs(axes.coordinate(Vectors.subtract(centre, middle), 0)))
                        .average()
                        .orElseThrow())
                .orElse(0.0);
        return cage && beside < MOST_BESIDE_SPINE;
    }

    /** Mean of the centres of the vertebrae. */
    private Optional<double[]> spine() {
        List<double[]> spine = vertebrae();
        return spine.isEmpty()
                ? Optional.empty()
                : Optional.of(IntStream.range(0, 3)
                        .mapToDouble(axis -> spine.stream()
                                .mapToDouble(centre -> centre[axis])
                                .average()
                                .orElseThrow())
                        .toArray());
    }

    /** Expects the first structure at the smaller coordinate. */
    private void expect(String less, String more, int axis) {
        if (centres.containsKey(less) && centres.containsKey(more)) {
            relations.add(new Relation(axis, Vectors.subtract(centres.get(more), centres.get(less))));
        }
    }

    private void expectPair(String right, String left) {
        if (centres.containsKey(right) && centres.containsKey(left)) {
            addPair(Vectors.subtract(centres.get(left), centres.get(right)));
        }
    }

    private void addPair(double[] apart) {
        Relation pair = new Relation(0, apart);
        relations.add(pair);
        pairs.add(pair);
    }

    /** Whether most pairs of right and left structures lie on each other's sides, and all else as the file states. */
    boolean haveSidesExchanged() {
        boolean upright = IntStream.of(1, 2).allMatch(axis -> share(relations, BodyAxes.STATED, axis) >= MOST);
        return upright && pairs.size() >= LEAST_PAIRS && share(pairs, BodyAxes.MIRRORED, 0) >= MOST;
    }

    /** Share of comparisons along a coordinate that hold in these axes; 1 without any. */
    private static double share(List<Relation> relations, BodyAxes axes, int axis) {
        return relations.stream()
                .filter(r -> r.axis() == axis)
                .mapToInt(r -> r.holds(axes) ? 1 : 0)
                .average()
                .orElse(1);
    }

    /** Number of comparisons made. */
    int compared() {
        return relations.size();
    }

    /** Whether structures are compared along a coordinate. */
    boolean compares(int axis) {
        return relations.stream().anyMatch(r -> r.axis() == axis);
    }

    /** Share of the comparisons that hold in the axes that the file states. */
    double share() {
        return share(BodyAxes.STATED);
    }

    /** Share of the comparisons that hold in other axes; 0 without comparisons. */
    double share(BodyAxes axes) {
        return relations.stream().mapToInt(r -> r.holds(axes) ? 1 : 0).average().orElse(0);
    }

    /**
     * How nearly the compared structures lie along the coordinates by which they are compared: the mean cosine, of each
     * coordinate alike.
     */
    double alignment(BodyAxes axes) {
        return IntStream.range(0, 3)
                .mapToObj(axis -> relations.stream()
                        .filter(r -> r.axis() == axis)
                        .mapToDouble(r -> axes.coordinate(r.apart(), axis) / Vectors.length(r.apart()))
                        .average())
                .flatMapToDouble(OptionalDouble::stream)
                .average()
                .orElse(0);
    }

    /** Whether most of the comparisons along each coordinate hold in these axes. */
    boolean fit(BodyAxes axes) {
        return IntStream.range(0, 3).allMatch(axis -> share(relations, axes, axis) >= MOST);
    }
}
