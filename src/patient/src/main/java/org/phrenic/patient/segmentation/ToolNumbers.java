package org.phrenic.patient.segmentation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
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
        List<ToolNumbers> versions =
                FILES.stream().map(file -> present(file, grid)).toList();
        Function<LabelPlaces, Optional<BodyAxes>> stated = places -> Optional.of(BodyAxes.STATED);
        ToolNumbers best = better(versions, stated);
        return best.score(stated) > 0 ? best : better(versions, StatedAxes::ofNumbers);
    }

    private static ToolNumbers present(String file, LabelGrid grid) {
        int[] counts = grid.counts();
        Map<Integer, String> structures = new TreeMap<>();
        CsvTable table = table(file);
        double[] labels = table.numbers("label");
        for (int row = 0; row < labels.length; row++) {
            if (labels[row] < counts.length && counts[(int) labels[row]] > 0) {
                structures.put((int) labels[row], table.texts("structure").get(row));
            }
        }
        return new ToolNumbers(file, structures, new LabelPlaces(grid, structures, lobes(table)));
    }

    /** Label of the lower lobe of each lung by that of the upper one. */
    private static Map<Integer, Integer> lobes(CsvTable table) {
        List<String> names = table.texts("name");
        double[] labels = table.numbers("label");
        Map<Integer, Integer> lobes = new TreeMap<>();
        for (String side : List.of("right", "left")) {
            int upper = names.indexOf("lung_upper_lobe_" + side);
            int lower = names.indexOf("lung_lower_lobe_" + side);
            lobes.put((int) labels[upper], (int) labels[lower]);
        }
        return lobes;
    }

    private static ToolNumbers better(List<ToolNumbers> versions, Function<LabelPlaces, Optional<BodyAxes>> axesOf) {
        ToolNumbers best = versions.get(0);
        for (ToolNumbers version : versions) {
            if (version.score(axesOf) > Math.max(0, best.score(axesOf))) {
                best = version;
            }
        }
        return best;
    }

    /** Comparisons of places that hold in some axes without those that fail; negative without axes. */
    private double score(Function<LabelPlaces, Optional<BodyAxes>> axesOf) {
        return axesOf.apply(places)
                .map(axes -> places.compared() * (2 * places.share(axes) - 1))
                .orElse(-1.0);
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
