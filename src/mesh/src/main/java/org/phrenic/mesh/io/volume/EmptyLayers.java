package org.phrenic.mesh.io.volume;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import org.phrenic.mesh.io.raster.VoxelDecoder;
import org.phrenic.mesh.voxel.LabelGrid;

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
     * Greatest cross-section of a structure in the last layer over that in the next two where it is taken to end. Where
     * a rounded end begins within the last layer, the sections of two layers are as 1 to 2 at most, and along the arch
     * of a rib as 1 to the root of 2; where a structure is cut through, they are alike.
     */
    private static final double TAPERED = 0.75;

    private static final int FARTHER_IN = 2;
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
     * @param cropped whether layers without labels are known to be left out, so that structures at both faces of a
     *     direction show that it ends with them
     */
    static LabelGrid beyond(LabelGrid grid, boolean cropped) {
        int[] box = grid.box(label -> label > 0);
        int[] last = {grid.columns() - 1, grid.rows() - 1, grid.slices() - 1};
        boolean[] ends = new boolean[3];
        for (int direction = 0; direction < 3; direction++) {
            ends[direction] = box[direction] == 0 && box[3 + direction] == last[direction];
        }
        boolean all = ends[0] && ends[1] && ends[2];
        return all || (cropped && (ends[0] || ends[1] || ends[2])) ? new EmptyLayers(grid).padded(ends) : grid;
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
            int within = 0;
            for (int layer = 1; layer <= FARTHER_IN && layer < areas.length; layer++) {
                within = Math.max(within, areas[face + layer * inward][s]);
            }
            int number = s;
            if (mm2 * last[s] > TIP_MM2
                    && last[s] > TAPERED * within
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
        double[] toMm = grid.toMm();
        for (int row = 0; row < 3; row++) {
            for (int direction = 0; direction < 3; direction++) {
                toMm[4 * row + 3] -= before[direction] * toMm[4 * row + direction];
            }
        }
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
