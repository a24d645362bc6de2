package org.phrenic.patient.label;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Organs, vertebrae and ribs of a trunk as boxes of voxels of 5 mm, about where and as large as in people. Columns run
 * to the left, rows to the back, slices up.
 */
final class TrunkVoxels {
    private static final int COLUMNS = 90;
    private static final int ROWS = 55;
    private static final int SLICES = 155;
    private static final double SPACING_MM = 5;
    private static final int VERTEBRAE = 17;

    /** Centre and half sizes of each structure, voxels. */
    private static final Map<String, int[]> BOXES = new TreeMap<>(Map.ofEntries(
            Map.entry("urinary_bladder", new int[] {40, 10, 10, 5, 5, 8}),
            Map.entry("small_bowel", new int[] {40, 10, 32, 16, 5, 10}),
            Map.entry("colon", new int[] {40, 24, 30, 20, 3, 10}),
            Map.entry("kidney_R", new int[] {25, 42, 50, 4, 5, 8}),
            Map.entry("kidney_L", new int[] {60, 42, 52, 4, 5, 8}),
            Map.entry("duodenum", new int[] {34, 30, 48, 4, 4, 5}),
            Map.entry("pancreas", new int[] {48, 30, 62, 8, 2, 4}),
            Map.entry("liver", new int[] {22, 14, 74, 15, 10, 10}),
            Map.entry("gallbladder", new int[] {24, 8, 58, 3, 3, 4}),
            Map.entry("stomach", new int[] {56, 14, 70, 7, 5, 10}),
            Map.entry("spleen", new int[] {74, 34, 70, 5, 5, 8}),
            Map.entry("adrenal_gland_R", new int[] {28, 40, 66, 1, 2, 3}),
            Map.entry("adrenal_gland_L", new int[] {56, 40, 66, 1, 2, 3}),
            Map.entry("aorta", new int[] {43, 42, 75, 2, 2, 37}),
            Map.entry("inferior_vena_cava", new int[] {36, 42, 62, 2, 2, 20}),
            Map.entry("portal_and_splenic_vein", new int[] {42, 24, 66, 4, 3, 3}),
            Map.entry("oesophagus", new int[] {46, 35, 110, 2, 2, 15}),
            Map.entry("heart", new int[] {46, 14, 100, 10, 7, 10}),
            Map.entry("trachea", new int[] {40, 30, 142, 2, 2, 10}),
            Map.entry("lung_R", new int[] {16, 28, 112, 10, 10, 23}),
            Map.entry("lung_L", new int[] {72, 28, 112, 9, 10, 22})));

    private TrunkVoxels() {}

    /** The trunk with the labels of a table. Of a lung with several labels the upper ones get the upper parts. */
    static LabelVolume labelled(NumberTable table) {
        byte[] labels = new byte[COLUMNS * ROWS * SLICES];
        table.structures().values().stream().distinct().forEach(structure -> {
            List<Integer> own = table.structures().keySet().stream()
                    .filter(label -> table.structures().get(label).equals(structure))
                    .toList();
            List<String> parts =
                    switch (structure) {
                        case "lungs" -> List.of("lung_R", "lung_L");
                        case "organ_kidneys" -> List.of("kidney_R", "kidney_L");
                        case "ribs" ->
                            IntStream.rangeClosed(1, 24)
                                    .mapToObj(
                                            rib -> String.format("rib_%02d_%s", (rib + 1) / 2, rib % 2 > 0 ? "R" : "L"))
                                    .toList();
                        default -> List.of(structure);
                    };
            parts.forEach(part -> {
                int[] box = BOXES.containsKey(part) ? BOXES.get(part) : bone(part);
                if (box.length > 0) {
                    fill(labels, box, own);
                }
            });
        });
        double s = SPACING_MM;
        LabelGrid grid = LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0});
        return new LabelVolume(grid, Map.of(), List.of());
    }

    /** The box of a vertebra from T1 to L5, or of a rib beside one from T1 to T12; empty for other structures. */
    private static int[] bone(String structure) {
        for (int level = 1; level <= VERTEBRAE; level++) {
            int height = 145 - 7 * level;
            int lumbar = level - 12;
            if (structure.equals(
                    String.format(lumbar < 1 ? "vertebra_T%02d" : "vertebra_L%02d", lumbar < 1 ? level : lumbar))) {
                return new int[] {40, 50, height, 3, 3, 2};
            } else if (structure.equals(String.format("rib_%02d_R", level))) {
                return new int[] {3, 28, height, 1, 10, 2};
            } else if (structure.equals(String.format("rib_%02d_L", level))) {
                return new int[] {85, 28, height, 1, 10, 2};
            }
        }
        return new int[0];
    }

    private static void fill(byte[] labels, int[] box, List<Integer> own) {
        for (int k = box[2] - box[5]; k <= box[2] + box[5]; k++) {
            int part = own.size() * (box[2] + box[5] - k) / (2 * box[5] + 1);
            for (int j = box[1] - box[4]; j <= box[1] + box[4]; j++) {
                for (int i = box[0] - box[3]; i <= box[0] + box[3]; i++) {
                    labels[i + COLUMNS * (j + ROWS * k)] = own.get(part).byteValue();
                }
            }
        }
    }
}
