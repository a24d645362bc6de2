package org.phrenic.mesh.io.volume;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.mesh.io.raster.VoxelDecoder;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Empty slices beyond the ends of a volume whose file leaves out slices without labels. The first and last slices of
 * such a volume are those of its structures, not of the scan, and a structure that tapers off there is not truncated.
 */
final class EmptySlices {
    /**
     * Greatest cross-section of a structure in the last slice, over its greatest, where it is taken to end: an
     * ellipsoid of 150 mm has 0.13 at 5 mm from its end. A larger one is a cut by the end of the scan.
     */
    private static final double TAPERED = 0.3;

    private EmptySlices() {}

    /**
     * The grid with one more slice at each end at which every structure tapers off. A file with an empty slice at
     * either end leaves out none, and its grid stays as it is; so does one with no room for more slices.
     */
    static LabelGrid beyond(LabelGrid grid) {
        int[][] areas = new int[grid.slices()][];
        int[] greatest = new int[grid.counts().length];
        int slice = grid.columns() * grid.rows();
        for (int k = 0; k < areas.length; k++) {
            int[] area = new int[greatest.length];
            for (int v = k * slice; v < (k + 1) * slice; v++) {
                area[grid.label(v)]++;
            }
            for (int label = 1; label < area.length; label++) {
                greatest[label] = Math.max(greatest[label], area[label]);
            }
            areas[k] = k == 0 || k == areas.length - 1 ? area : null;
        }
        if (isEmpty(areas[0]) || isEmpty(areas[areas.length - 1])) {
            return grid;
        }
        int before = tapers(areas[0], greatest) ? 1 : 0;
        int after = tapers(areas[areas.length - 1], greatest) ? 1 : 0;
        if (before + after == 0 || !fits(grid.columns(), grid.rows(), grid.slices() + before + after)) {
            return grid;
        }
        boolean wide =
                IntStream.range(LabelGrid.MAX_BYTE_LABEL + 1, greatest.length).anyMatch(label -> greatest[label] > 0);
        return padded(grid, before, after, wide);
    }

    private static boolean isEmpty(int[] area) {
        return Arrays.stream(area, 1, area.length).sum() == 0;
    }

    /** Whether no structure has a large part of its greatest cross-section in a slice. */
    private static boolean tapers(int[] area, int[] greatest) {
        return IntStream.range(1, area.length).allMatch(label -> area[label] <= TAPERED * greatest[label]);
    }

    /** Whether the voxels of a volume of this size fit into an array. */
    static boolean fits(int columns, int rows, int slices) {
        return (long) columns * rows * slices <= VoxelDecoder.MAX_VOXELS;
    }

    private static LabelGrid padded(LabelGrid grid, int before, int after, boolean wide) {
        int slices = grid.slices() + before + after;
        int first = before * grid.columns() * grid.rows();
        int voxels = grid.columns() * grid.rows() * slices;
        double[] toMm = grid.toMm().clone();
        for (int row = 0; row < 3; row++) {
            toMm[4 * row + 3] -= before * toMm[4 * row + 2];
        }
        if (wide) {
            short[] labels = new short[voxels];
            for (int v = 0; v < grid.voxelCount(); v++) {
                labels[first + v] = (short) grid.label(v);
            }
            return LabelGrid.of(grid.columns(), grid.rows(), slices, labels, toMm);
        }
        byte[] labels = new byte[voxels];
        for (int v = 0; v < grid.voxelCount(); v++) {
            labels[first + v] = (byte) grid.label(v);
        }
        return LabelGrid.of(grid.columns(), grid.rows(), slices, labels, toMm);
    }
}
