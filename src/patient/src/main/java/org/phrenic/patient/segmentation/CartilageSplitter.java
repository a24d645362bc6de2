package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Tells costal cartilages under one label apart: each voxel belongs to the rib from which the fewest steps through
 * cartilage lead to it.
 */
public final class CartilageSplitter {
    private static final int CARTILAGES = 10;
    /** Rib and cartilage are this many voxels apart at most. */
    private static final int GAP = 2;

    private CartilageSplitter() {}

    /** Replaces the part of all cartilages by one for each rib; a sentence about what no rib leads to. */
    public static Optional<String> split(Segmentation parts) {
        int all = parts.find(LabelTable.COSTAL_CARTILAGES);
        List<String> names = new ArrayList<>();
        byte[] markOfPart = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        for (String side : List.of("R", "L")) {
            for (int level = 1; level <= CARTILAGES; level++) {
                int rib = parts.find(String.format(Locale.ROOT, "rib_%02d_%s", level, side));
                if (rib > 0) {
                    names.add(String.format(Locale.ROOT, "costal_cartilage_%02d_%s", level, side));
                    markOfPart[rib] = (byte) names.size();
                }
            }
        }
        VoxelRegion flood = new VoxelRegion(parts, all);
        byte[] marks = new byte[flood.cells()];
        for (int cell = 0; cell < marks.length; cell++) {
            if (flood.isMember(cell)) {
                marks[cell] = firstBeside(parts, markOfPart, flood.voxel(cell));
            }
        }
        flood.growRegions(marks);
        byte[] part = new byte[names.size() + 1];
        int lost = 0;
        int total = 0;
        for (int cell = 0; cell < marks.length; cell++) {
            if (flood.isMember(cell)) {
                total++;
                int mark = marks[cell];
                lost += mark == 0 ? 1 : 0;
                if (mark > 0 && part[mark] == 0) {
                    part[mark] = (byte) parts.segment(names.get(mark - 1));
                    parts.inheritFrom(names.get(mark - 1), LabelTable.COSTAL_CARTILAGES);
                }
                parts.voxels[flood.voxel(cell)] = part[mark];
            }
        }
        return lost == 0
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s: %.0f %% of it left out, no rib of the scan leads to it",
                        LabelTable.COSTAL_CARTILAGES,
                        100.0 * lost / total));
    }

    /** The first of the ribs that a voxel lies beside, 0 for none. */
    private static byte firstBeside(Segmentation parts, byte[] markOfPart, int voxel) {
        int i = voxel % parts.columns;
        int j = voxel / parts.columns % parts.rows;
        int k = voxel / parts.columns / parts.rows;
        byte first = 0;
        for (int z = Math.max(0, k - GAP); z <= Math.min(parts.slices - 1, k + GAP); z++) {
            for (int y = Math.max(0, j - GAP); y <= Math.min(parts.rows - 1, j + GAP); y++) {
                for (int x = Math.max(0, i - GAP); x <= Math.min(parts.columns - 1, i + GAP); x++) {
                    int part = parts.voxels[x + parts.columns * (y + parts.rows * z)] & LabelGrid.MAX_BYTE_LABEL;
                    byte mark = markOfPart[part];
                    first = mark > 0 && (first == 0 || mark < first) ? mark : first;
                }
            }
        }
        return first;
    }
}
