package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Whether labels lie where their structures lie in people: right ribs and lung to the right of the left ones, ribs and
 * vertebrae in descending order, lungs above the liver, liver to the right of the spleen. Ribs are compared where both
 * lie in one sector about the body's axis: of ribs that the scan cuts off, middles tell nothing.
 */
final class LabelPlaces {
    /** Least number of comparisons for a judgement. */
    static final int ENOUGH = 3;

    /** Number of sectors about the body's axis. */
    private static final int SECTORS = 36;
    /** Least number of voxels of a sector that counts, over that of the fullest one: the rest may be specks. */
    private static final double LEAST_SECTOR = 0.2;

    private final Map<String, double[]> centres = new TreeMap<>();
    /** Of each rib the sum of heights (mm) and the number of voxels in each sector. */
    private final Map<String, double[][]> ribs = new TreeMap<>();

    private int right;
    private int compared;

    /** @param structures structure by label */
    LabelPlaces(LabelGrid grid, Map<Integer, String> structures) {
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
                double[] centre = new double[3];
                grid.voxelToMm(sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], centre);
                centres.put(structure, centre);
            }
        });
        measureRibs(grid, structures);
        compare();
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
        List<double[]> places = new ArrayList<>();
        List<String> structures = new ArrayList<>();
        centres.forEach((structure, centre) -> StructureName.parse(structure).ifPresent(name -> {
            structures.add(structure);
            names.add(name);
            places.add(centre);
        }));
        for (int a = 0; a < names.size(); a++) {
            for (int b = 0; b < names.size(); b++) {
                StructureName one = names.get(a);
                StructureName other = names.get(b);
                boolean sided = one.side() == Side.RIGHT && other.side() == Side.LEFT;
                if (sided
                        && one.kind() == other.kind()
                        && one.level() == other.level()
                        && !one.kind().isNamed()) {
                    // The x axis points to the patient's left.
                    judge(places.get(a)[0] < places.get(b)[0]);
                }
                boolean next =
                        one.kind() == other.kind() && one.side() == other.side() && other.level() == one.level() + 1;
                if (next && one.kind() == StructureKind.VERTEBRA) {
                    judge(places.get(a)[2] > places.get(b)[2]);
                } else if (next && one.kind() == StructureKind.RIB) {
                    heightAbove(structures.get(a), structures.get(b)).ifPresent(above -> judge(above > 0));
                }
            }
        }
        judge("liver", "spleen", 0);
        judge("liver", "lung_R", 2);
        judge("spleen", "lung_L", 2);
        judge("kidney_R", "kidney_L", 0);
        judge("urinary_bladder", "heart", 2);
    }

    private void judge(boolean fits) {
        right += fits ? 1 : 0;
        compared++;
    }

    /** Judges that the first structure has the smaller coordinate. */
    private void judge(String less, String more, int axis) {
        Optional<double[]> a = Optional.ofNullable(centres.get(less));
        Optional<double[]> b = Optional.ofNullable(centres.get(more));
        if (a.isPresent() && b.isPresent()) {
            judge(a.get()[axis] < b.get()[axis]);
        }
    }

    /** Number of comparisons made. */
    int compared() {
        return compared;
    }

    /** Share of the comparisons that hold. */
    double share() {
        return compared == 0 ? 0 : (double) right / compared;
    }
}
