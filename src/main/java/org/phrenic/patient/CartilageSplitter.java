package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Tells costal cartilages under one label apart: each voxel belongs to the rib from which the fewest steps through cartilage lead to it. */
final class CartilageSplitter {
    private static final int CARTILAGES = 10;
    /** Rib and cartilage are this many voxels apart at most. */
    private static final int GAP = 2;

    private CartilageSplitter() {}

    /** Replaces the part of all cartilages by one for each rib; a sentence about what no rib leads to. */
    static Optional<String> split(Parts parts) {
        int all = parts.find(LabelMap.COSTAL_CARTILAGES);
        int[] marks = new int[parts.voxels.length];
        List<String> names = new ArrayList<>();
        for (String side : List.of("R", "L")) {
            for (int level = 1; level <= CARTILAGES; level++) {
                int rib = parts.find(String.format(Locale.ROOT, "rib_%02d_%s", level, side));
                if (rib > 0) {
                    names.add(String.format(Locale.ROOT, "costal_cartilage_%02d_%s", level, side));
                    mark(parts, all, rib, names.size(), marks);
                }
            }
        }
        new VoxelFlood(parts, all).spread(marks);
        byte[] part = new byte[names.size() + 1];
        int lost = 0;
        int total = 0;
        for (int v = 0; v < marks.length; v++) {
            if (parts.voxels[v] == (byte) all) {
                total++;
                int mark = marks[v];
                lost += mark == 0 ? 1 : 0;
                if (mark > 0 && part[mark] == 0) {
                    part[mark] = (byte) parts.part(names.get(mark - 1));
                    parts.inherit(names.get(mark - 1), LabelMap.COSTAL_CARTILAGES);
                }
                parts.voxels[v] = part[mark];
            }
        }
        return lost == 0
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s: %.0f %% of it left out, no rib of the scan leads to it",
                        LabelMap.COSTAL_CARTILAGES,
                        100.0 * lost / total));
    }

    private static void mark(Parts parts, int all, int rib, int mark, int[] marks) {
        int voxel = 0;
        for (int k = 0; k < parts.slices; k++) {
            for (int j = 0; j < parts.rows; j++) {
                for (int i = 0; i < parts.columns; i++, voxel++) {
                    if (parts.voxels[voxel] == (byte) all && marks[voxel] == 0 && isBeside(parts, rib, i, j, k)) {
                        marks[voxel] = mark;
                    }
                }
            }
        }
    }

    private static boolean isBeside(Parts parts, int rib, int i, int j, int k) {
        for (int z = Math.max(0, k - GAP); z <= Math.min(parts.slices - 1, k + GAP); z++) {
            for (int y = Math.max(0, j - GAP); y <= Math.min(parts.rows - 1, j + GAP); y++) {
                for (int x = Math.max(0, i - GAP); x <= Math.min(parts.columns - 1, i + GAP); x++) {
                    if (parts.voxels[x + parts.columns * (y + parts.rows * z)] == (byte) rib) {
                        return true;
                    }
                }
            }
        }
        return false;
    }
}
