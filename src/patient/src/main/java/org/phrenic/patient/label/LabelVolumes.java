package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.phrenic.document.CsvTable;

/**
 * Whether structures are as large as in people, one over another: the ratio of two volumes is compared with that of
 * typical ones, which does not depend on the spacing, and each with its own. Two spleens may differ by a factor of
 * four, a liver and a gall bladder do so by fifty. A structure that the volume may cut off is left out, but for one too
 * large.
 *
 * @param compared number of pairs of structures
 * @param holding number of pairs whose ratio is within a factor of {@value #FACTOR} of the typical one
 * @param ofPeople share of the structures that are within that factor of their typical volume; 0 if one of them is
 *     beyond a factor of {@value #ABSURD}, 1 without structures
 */
record LabelVolumes(int compared, int holding, double ofPeople) {
    private static final double MM3_PER_ML = 1000;
    private static final double FACTOR = 4;
    /** Factor by which no volume differs from the typical one, as with a kidney for a lung. */
    private static final double ABSURD = 12;
    /** Typical volumes of an adult's structures, ml. */
    private static final Map<String, Double> TYPICAL = typical();

    private static Map<String, Double> typical() {
        CsvTable table = NumberTable.shipped("volumes.csv");
        Map<String, Double> typical = new TreeMap<>();
        double[] volumes = table.numbers("ml");
        for (int row = 0; row < volumes.length; row++) {
            typical.put(table.texts("structure").get(row), volumes[row]);
        }
        return typical;
    }

    /** Compares all pairs of structures. */
    static LabelVolumes of(LabelPositions positions, Map<Integer, String> structures) {
        Map<String, Double> all = new TreeMap<>();
        Map<String, Double> voxels = new TreeMap<>();
        structures.forEach((label, structure) -> {
            if (TYPICAL.containsKey(structure) && positions.count(label) > 0) {
                double count = positions.isAtEnd(label) ? Double.NaN : positions.count(label);
                voxels.merge(structure, count, Double::sum);
                all.merge(structure, (double) positions.count(label), Double::sum);
            }
        });
        voxels.values().removeIf(count -> count.isNaN());
        List<Double> excess = new ArrayList<>();
        voxels.forEach((structure, count) -> excess.add(StrictMath.log(count / TYPICAL.get(structure))));
        int holding = 0;
        for (int a = 0; a < excess.size(); a++) {
            for (int b = 0; b < a; b++) {
                holding += Math.abs(excess.get(a) - excess.get(b)) < StrictMath.log(FACTOR) ? 1 : 0;
            }
        }
        return new LabelVolumes(
                excess.size() * (excess.size() - 1) / 2,
                holding,
                ofPeople(all, voxels.keySet(), positions.voxelVolume() / MM3_PER_ML));
    }

    /** @param whole structures that the volume does not cut off */
    private static double ofPeople(Map<String, Double> voxels, Set<String> whole, double voxelMl) {
        List<Double> excess = new ArrayList<>();
        voxels.forEach((structure, count) -> {
            double factor = count * voxelMl / TYPICAL.get(structure);
            if (whole.contains(structure) || factor > FACTOR) {
                excess.add(Math.abs(StrictMath.log(factor)));
            }
        });
        boolean absurd = excess.stream().anyMatch(factor -> factor > StrictMath.log(ABSURD));
        return absurd
                ? 0
                : excess.stream()
                        .mapToInt(factor -> factor < StrictMath.log(FACTOR) ? 1 : 0)
                        .average()
                        .orElse(1);
    }

    /** Share of the pairs that hold; 1 without pairs. */
    double share() {
        return compared == 0 ? 1 : (double) holding / compared;
    }
}
