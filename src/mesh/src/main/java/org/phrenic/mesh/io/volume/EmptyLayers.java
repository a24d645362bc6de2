package org.phrenic.mesh.io.volume;

import java.util.BitSet;
import java.util.stream.IntStream;
import org.phrenic.mesh.io.raster.VoxelDecoder;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Empty layers beyond the faces of a volume that ends with its structures, as one that is cropped to them or that
 * leaves out slices without labels. Such a face is not one of the scan, and a structure that tapers off there is not
 * truncated. A face at which any structure is cut through stays as it is.
 */
final class EmptyLayers {
    /**
     * Greatest cross-section of a structure in the last layer, over its greatest, where it is taken to end: the tip of
     * a spinous process, or an ellipsoid of 150 mm at 4 mm from its end.
     */
    private static final double TIP = 0.1;
    /**
     * The same over its cross-section two layers farther in. Where a rounded end begins within the last layer, the
     * sections are as 1 to 3 at most, and along the arch of a rib as 1 to the root of 3; where a structure is cut
     * through, they are alike.
     */
    private static final double TAPERED = 0.65;

    private static final int FARTHER_IN = 2;

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
     */
    static LabelGrid beyond(LabelGrid grid) {
        EmptyLayers layers = new EmptyLayers(grid);
        int[] before = new int[3];
        int[] size = layers.sizes.clone();
        for (int direction = 0; direction < 3 && layers.structures > 0; direction++) {
            int[][] areas = layers.areas(direction);
            before[direction] = layers.tapers(areas, 0, 1) ? 1 : 0;
            int after = layers.tapers(areas, areas.length - 1, -1) ? 1 : 0;
            size[direction] += before[direction] + after;
        }
        boolean same = IntStream.range(0, 3).allMatch(direction -> size[direction] == layers.sizes[direction]);
        return same || !fits(size[0], size[1], size[2]) ? grid : layers.padded(before, size);
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

    /** Whether structures touch a face and all of them end there. */
    private boolean tapers(int[][] areas, int face, int inward) {
        int[] last = areas[face];
        int within = face + FARTHER_IN * inward;
        boolean touched = false;
        for (int s = 0; s < structures; s++) {
            if (last[s] > 0) {
                int number = s;
                touched = true;
                int greatest = IntStream.range(0, areas.length)
                        .map(layer -> areas[layer][number])
                        .max()
                        .orElseThrow();
                boolean isRounded = within >= 0 && within < areas.length && last[s] <= TAPERED * areas[within][s];
                if (!isRounded && last[s] > TIP * greatest) {
                    return false;
                }
            }
        }
        return touched;
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
