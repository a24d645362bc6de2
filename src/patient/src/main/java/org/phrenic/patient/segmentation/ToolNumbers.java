package org.phrenic.patient.segmentation;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.document.CsvTable;
import org.phrenic.document.ShippedFile;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Label numbers of a version of TotalSegmentator (Wasserthal et al. 2023, doi 10.1148/ryai.230024), task {@code total}.
 *
 * @param file name of the shipped table
 * @param structures structure by label, of the labels that the volume has
 * @param places whether these labels lie where their structures lie
 */
record ToolNumbers(String file, Map<Integer, String> structures, LabelPlaces places) {
    /** Tables of version 2, which has 117 classes, and of version 1, which has 104 in another order. */
    private static final List<String> FILES = List.of("totalsegmentator.csv", "totalsegmentator-v1.csv");

    /** The numbers of the version that fits a volume better; version 2 where both fit alike. */
    static ToolNumbers of(LabelGrid grid) {
        int[] counts = grid.counts();
        ToolNumbers best = null;
        for (String file : FILES) {
            Map<Integer, String> structures = new TreeMap<>();
            CsvTable table = table(file);
            double[] labels = table.numbers("label");
            for (int row = 0; row < labels.length; row++) {
                if (labels[row] < counts.length && counts[(int) labels[row]] > 0) {
                    structures.put((int) labels[row], table.texts("structure").get(row));
                }
            }
            ToolNumbers numbers = new ToolNumbers(file, structures, new LabelPlaces(grid, structures));
            best = best == null || numbers.score() > Math.max(0, best.score()) ? numbers : best;
        }
        return best;
    }

    /** Comparisons of places that hold without those that fail. */
    private double score() {
        return places.compared() * (2 * places.share() - 1);
    }

    /** Structure by the name that the tool gives to a label. */
    static Map<String, String> byName() {
        Map<String, String> names = new TreeMap<>();
        for (String file : FILES) {
            CsvTable table = table(file);
            for (int row = 0; row < table.texts("structure").size(); row++) {
                names.put(table.texts("name").get(row), table.texts("structure").get(row));
            }
        }
        return names;
    }

    /** The shipped table of this version. */
    CsvTable table() {
        return table(file);
    }

    private static CsvTable table(String file) {
        return CsvTable.parse(file, ShippedFile.text("labels/" + file));
    }
}
