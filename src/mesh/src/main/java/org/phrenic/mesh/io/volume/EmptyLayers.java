package org.phrenic.mesh.io.volume;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import org.phrenic.mesh.io.raster.VoxelDecoder;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * Empty layers beyond the faces of a volume that ends with its structures, as one that is cropped to them or that
 * leaves out slices without labels. Such a face is not one of the scan, and a structure that tapers off there is not
 * truncated. A face at which any structure is cut through stays as it is. Of a volume whose file may have left nothing
 * out, structures at all six faces show that it is cropped.
 */
final class EmptyLayers {
    /** Greatest cross-section of a tip in the last layer, as of a spinous process, mm^2. */
    private static final double TIP_MM2 = 150;
    /**
     * Greatest cross-section of a structure in the last layer over that in the next one where it is taken to end: half,
     * and a little more, where a rounded end begins within the last layer. Where it is cut through they are alike.
     */
    private static final double ROUNDED = 0.55;
    /**
     * The same, of the next two, for one that is thin there, as the arch of a rib, whose sections are as 1 to the root
     * of 2.
     */
    private static final double ARCHED = 0.75;

    private static final double THIN_MM2 = 1000;
    /** Structures of fewer voxels are specks, which say nothing of the scan's ends. */
    private static final int LEAST_VOXELS = 30;

    private final LabelGrid grid;
    private final int[] sizes;
    /** Number of each structure that touches a face, by its label; -1 for others. */
    private final int[] structure;

    private final int structures;

    private EmptyLayers(LabelGrid grid) {
        this.grid = grid;
        sizes = new int[] {grid.columns(), grid.rows(), grid.slices()};
        BitSet touching = touching();
        structures = touching.cardinality();
        structure = new int[touching.length()];
        int next = 0;
        for (int label = 0; label < structure.length; label++) {
            structure[label] = touching.get(label) ? next++ : -1;
        }
    }

    /**
     * The grid with one more layer at each face that structures touch and at which all of them taper off; the grid as
     * it is where there is none, or no room for more layers.
     *
     * @param extent in directions of which layers without labels are left out, structures at both faces show that the
     *     volume ends with them; else structures at all six faces do
     */
    static LabelGrid beyond(LabelGrid grid, LabelVolume.Extent extent) {
        int[] box = grid.box(label -> label > 0);
        int[] last = {grid.columns() - 1, grid.rows() - 1, grid.slices() - 1};
        boolean[] ends = new boolean[3];
        for (int direction = 0; direction < 3; direction++) {
            ends[direction] = box[direction] == 0 && box[3 + direction] == last[direction];
        }
        if (!(ends[0] && ends[1] && ends[2])) {
            boolean ofLabels = extent == LabelVolume.Extent.LABELS;
            ends[0] &= ofLabels;
            ends[1] &= ofLabels;
            ends[2] &= extent != LabelVolume.Extent.FIELD;
        }
        return ends[0] || ends[1] || ends[2] ? new EmptyLayers(grid).padded(ends) : grid;
    }

    private LabelGrid padded(boolean[] ends) {
        int[] before = new int[3];
        int[] size = sizes.clone();
        for (int direction = 0; direction < 3; direction++) {
            if (ends[direction]) {
                int[][] areas = areas(direction);
                double mm2 = grid.voxelVolume() / grid.spacing(direction);
                before[direction] = tapers(areas, 0, 1, mm2) ? 1 : 0;
                int after = tapers(areas, areas.length - 1, -1, mm2) ? 1 : 0;
                size[direction] += before[direction] + after;
            }
        }
        return Arrays.equals(size, sizes) || !fits(size[0], size[1], size[2]) ? grid : padded(before, size);
    }

    /** Labels in the outermost layers. */
    private BitSet touching() {
        BitSet labels = new BitSet();
        for (int k = 0; k < sizes[2]; k++) {
            for (int j = 0; j < sizes[1]; j++) {
                boolean face = k == 0 || k == sizes[2] - 1 || j == 0 || j == sizes[1] - 1;
                int row = sizes[0] * (j + sizes[1] * k);
                int step = face ? 1 : Math.max(1, sizes[0] - 1);
                for (int i = 0; i < sizes[0]; i += step) {
                    labels.set(grid.label(row + i));
                }
            }
        }
        labels.clear(0);
        return labels;
    }

    /** Voxels of each structure in each layer along a direction. */
    private int[][] areas(int direction) {
        int[][] areas = new int[sizes[direction]][structures];
        int voxel = 0;
        int[] at = new int[3];
        for (at[2] = 0; at[2] < sizes[2]; at[2]++) {
            for (at[1] = 0; at[1] < sizes[1]; at[1]++) {
                for (at[0] = 0; at[0] < sizes[0]; at[0]++) {
                    int label = grid.label(voxel++);
                    if (label > 0 && label < structure.length && structure[label] >= 0) {
                        areas[at[direction]][structure[label]]++;
                    }
                }
            }
        }
        return areas;
    }

    /** Whether all structures that touch a face end there, but for specks. */
    private boolean tapers(int[][] areas, int face, int inward, double mm2) {
        int[] last = areas[face];
        for (int s = 0; s < structures; s++) {
            int next = areas.length > 1 ? areas[face + inward][s] : 0;
            int within = areas.length > 2 ? Math.max(next, areas[face + 2 * inward][s]) : next;
            boolean isArch = mm2 * within <= THIN_MM2 && last[s] <= ARCHED * within;
            int number = s;
            if (mm2 * last[s] > TIP_MM2
                    && last[s] > ROUNDED * next
                    && !isArch
                    && Arrays.stream(areas).mapToInt(area -> area[number]).sum() >= LEAST_VOXELS) {
                return false;
            }
        }
        return true;
    }

    /** Whether the voxels of a volume of this size fit into an array. */
    static boolean fits(int columns, int rows, int slices) {
        return (long) columns * rows * slices <= VoxelDecoder.MAX_VOXELS;
    }

    private LabelGrid padded(int[] before, int[] size) {
        double[] toMm = VoxelBox.beginningAt(grid.toMm(), -before[0], -before[1], -before[2]);
        int voxels = size[0] * size[1] * size[2];
        int[] counts = grid.counts();
        boolean wide =
                IntStream.range(LabelGrid.MAX_BYTE_LABEL + 1, counts.length).anyMatch(label -> counts[label] > 0);
        byte[] bytes = new byte[wide ? 0 : voxels];
        short[] shorts = new short[wide ? voxels : 0];
        for (int k = 0; k < sizes[2]; k++) {
            for (int j = 0; j < sizes[1]; j++) {
                int from = sizes[0] * (j + sizes[1] * k);
                int to = before[0] + size[0] * (j + before[1] + size[1] * (k + before[2]));
                for (int i = 0; i < sizes[0]; i++) {
                    if (wide) {
                        shorts[to + i] = (short) grid.label(from + i);
                    } else {
                        bytes[to + i] = (byte) grid.label(from + i);
                    }
                }
            }
        }
        return wide
                ? LabelGrid.of(size[0], size[1], size[2], shorts, toMm)
                : LabelGrid.of(size[0], size[1], size[2], bytes, toMm);
    }
}
