package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Whether labels lie where their structures lie in people: right ribs and lung to the right of the left ones, ribs and
 * vertebrae in descending order, lungs above the liver, liver to the right of the spleen.
 */
final class LabelPlaces {
    /** Least number of comparisons for a judgement. */
    static final int ENOUGH = 3;

    private final Map<String, double[]> centres = new TreeMap<>();
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
        compare();
    }

    private void compare() {
        List<StructureName> names = new ArrayList<>();
        List<double[]> places = new ArrayList<>();
        centres.forEach((structure, centre) -> StructureName.parse(structure).ifPresent(name -> {
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
                boolean levelled = one.kind() == StructureKind.RIB || one.kind() == StructureKind.VERTEBRA;
                if (levelled
                        && one.kind() == other.kind()
                        && one.side() == other.side()
                        && other.level() == one.level() + 1) {
                    judge(places.get(a)[2] > places.get(b)[2]);
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
