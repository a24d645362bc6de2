package org.phrenic.mesh.io.volume;

import java.util.Arrays;
import java.util.stream.IntStream;
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
     * either end leaves out none, and its grid stays as it is.
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
        return before + after == 0 ? grid : padded(grid, before, after);
    }

    private static boolean isEmpty(int[] area) {
        return Arrays.stream(area, 1, area.length).sum() == 0;
    }

    /** Whether no structure has a large part of its greatest cross-section in a slice. */
    private static boolean tapers(int[] area, int[] greatest) {
        return IntStream.range(1, area.length).allMatch(label -> area[label] <= TAPERED * greatest[label]);
    }

    private static LabelGrid padded(LabelGrid grid, int before, int after) {
        int slices = grid.slices() + before + after;
        int first = before * grid.columns() * grid.rows();
        short[] labels = new short[grid.columns() * grid.rows() * slices];
        boolean wide = false;
        for (int v = 0; v < grid.voxelCount(); v++) {
            labels[first + v] = (short) grid.label(v);
            wide |= grid.label(v) > LabelGrid.MAX_BYTE_LABEL;
        }
        double[] toMm = grid.toMm().clone();
        for (int row = 0; row < 3; row++) {
            toMm[4 * row + 3] -= before * toMm[4 * row + 2];
        }
        if (wide) {
            return LabelGrid.of(grid.columns(), grid.rows(), slices, labels, toMm);
        }
        byte[] narrow = new byte[labels.length];
        for (int v = 0; v < labels.length; v++) {
            narrow[v] = (byte) labels[v];
        }
        return LabelGrid.of(grid.columns(), grid.rows(), slices, narrow, toMm);
    }
}
