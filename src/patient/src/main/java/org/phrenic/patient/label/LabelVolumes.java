package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.document.CsvTable;

/**
 * Whether structures are as large as in people, one over another: the ratio of two volumes is compared with that of
 * typical ones. Two spleens may differ by a factor of four, a liver and a gall bladder do so by fifty. The spacing of
 * voxels does not matter. Structures that the volume may cut off are left out.
 *
 * @param compared number of pairs of structures
 * @param holding number of pairs whose ratio is within a factor of {@value #FACTOR} of the typical one
 */
record LabelVolumes(int compared, int holding) {
    private static final double FACTOR = 4;
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
        Map<String, Double> voxels = new TreeMap<>();
        structures.forEach((label, structure) -> {
            if (TYPICAL.containsKey(structure) && positions.count(label) > 0) {
                double count = positions.isAtEnd(label) ? Double.NaN : positions.count(label);
                voxels.merge(structure, count, Double::sum);
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
        return new LabelVolumes(excess.size() * (excess.size() - 1) / 2, holding);
    }

    /** Share of the pairs that hold; 1 without pairs. */
    double share() {
        return compared == 0 ? 1 : (double) holding / compared;
    }
}
