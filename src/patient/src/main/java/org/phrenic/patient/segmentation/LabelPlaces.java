package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Whether labels lie where their structures lie in people: right ribs and lung to the right of the left ones, ribs and
 * vertebrae in descending order, lungs above the liver, upper lobes above lower ones, liver to the right of the spleen,
 * sternum and organs in front of the spine. Ribs are compared where both lie in one sector about the body's axis: of
 * ribs that the scan cuts off, middles tell nothing.
 */
final class LabelPlaces {
    /** Least number of comparisons for a judgement. */
    static final int ENOUGH = 3;

    /** Number of sectors about the body's axis. */
    private static final int SECTORS = 36;
    /** Least number of voxels of a sector that counts, over that of the fullest one: the rest may be specks. */
    private static final double LEAST_SECTOR = 0.2;
    /** Share of the comparisons along a coordinate that have to hold. */
    private static final double MOST = 0.8;

    private static final List<String> IN_FRONT_OF_SPINE =
            List.of("sternum", "sternum_manubrium", "sternum_body", "heart", "liver", "stomach");

    private final Map<String, double[]> centres = new TreeMap<>();
    /** Of each rib the sum of heights (mm) and the number of voxels in each sector. */
    private final Map<String, double[][]> ribs = new TreeMap<>();

    private final List<Relation> relations = new ArrayList<>();

    /** A vector between two structures of which one coordinate is positive in people. */
    private record Relation(int axis, double[] apart) {
        boolean holds(BodyAxes axes) {
            return axes.coordinate(apart, axis) > 0;
        }
    }

    /** @param structures structure by label */
    LabelPlaces(LabelGrid grid, Map<Integer, String> structures) {
        this(grid, structures, Map.of());
    }

    /** @param below label of the lower lobe of a lung by that of the upper one */
    LabelPlaces(LabelGrid grid, Map<Integer, String> structures, Map<Integer, Integer> below) {
        double[][] sums = new double[LabelGrid.MAX_LABEL + 1][];
        structures.keySet().forEach(label -> sums[label] = new double[4]);
        int voxel = 0;
        for (int k = 0; k < grid.slices(); k++) {
            for (int j = 0; j < grid.rows(); j++) {
                for (int i = 0; i < grid.columns(); i++) {
                    double[] sum = sums[grid.label(voxel++)];
                    if (sum != null) {
                        sum[0] += i;
                        sum[1] += j;
                        sum[2] += k;
                        sum[3]++;
                    }
                }
            }
        }
        Map<String, double[]> totals = new TreeMap<>();
        structures.forEach((label, structure) -> {
            double[] total = totals.computeIfAbsent(structure, s -> new double[4]);
            for (int n = 0; n < 4; n++) {
                total[n] += sums[label][n];
            }
        });
        totals.forEach((structure, sum) -> {
            if (sum[3] > 0) {
                centres.put(structure, centre(grid, sum));
            }
        });
        measureRibs(grid, structures);
        compare();
        below.forEach((upper, lower) -> {
            double[] one = sums[lower];
            double[] other = sums[upper];
            if (one != null && other != null && one[3] > 0 && other[3] > 0) {
                relations.add(new Relation(2, Vectors.subtract(centre(grid, other), centre(grid, one))));
            }
        });
    }

    private static double[] centre(LabelGrid grid, double[] sum) {
        double[] centre = new double[3];
        grid.voxelToMm(sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], centre);
        return centre;
    }

    private void measureRibs(LabelGrid grid, Map<Integer, String> structures) {
        double[][][] sectors = new double[LabelGrid.MAX_LABEL + 1][][];
        structures.forEach((label, structure) -> {
            if (isOf(structure, StructureKind.RIB)) {
                sectors[label] = ribs.computeIfAbsent(structure, s -> new double[SECTORS][2]);
            }
        });
        double x = centres.values().stream().mapToDouble(c -> c[0]).average().orElse(0);
        double y = centres.values().stream().mapToDouble(c -> c[1]).average().orElse(0);
        double[] p = new double[3];
        int voxel = 0;
        for (int k = 0; k < grid.slices(); k++) {
            for (int j = 0; j < grid.rows(); j++) {
                for (int i = 0; i < grid.columns(); i++) {
                    double[][] rib = sectors[grid.label(voxel++)];
                    if (rib != null) {
                        grid.voxelToMm(i, j, k, p);
                        double turn = Math.atan2(p[1] - y, p[0] - x) / (2 * Math.PI) + 0.5;
                        double[] sector = rib[Math.min(SECTORS - 1, (int) (SECTORS * turn))];
                        sector[0] += p[2];
                        sector[1]++;
                    }
                }
            }
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
        return IntStream.range(0, SECTORS)
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
        centres.keySet().forEach(structure -> StructureName.parse(structure).ifPresent(name -> {
            structures.add(structure);
            names.add(name);
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
        expect("kidney_R", "kidney_L", 0);
        expect("urinary_bladder", "heart", 2);
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
            relations.add(new Relation(0, apart));
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

    /** Mean of the centres of the vertebrae. */
    private Optional<double[]> spine() {
        List<double[]> spine = centres.entrySet().stream()
                .filter(entry -> isOf(entry.getKey(), StructureKind.VERTEBRA))
                .map(Map.Entry::getValue)
                .toList();
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
        return IntStream.range(0, 3)
                .allMatch(axis -> relations.stream()
                                .filter(r -> r.axis() == axis)
                                .mapToInt(r -> r.holds(axes) ? 1 : 0)
                                .average()
                                .orElse(1)
                        >= MOST);
    }
}
