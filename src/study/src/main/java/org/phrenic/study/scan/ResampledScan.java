package org.phrenic.study.scan;

import org.phrenic.mesh.voxel.LabelGrid;

/** A label volume with another number of voxels in the same box; each takes the label of the nearest voxel. */
final class ResampledScan {
    private ResampledScan() {}

    static LabelGrid of(LabelGrid grid, ScanSize size) {
        int n = Math.multiplyExact(Math.multiplyExact(size.columns(), size.rows()), size.slices());
        boolean small = grid.counts().length <= LabelGrid.MAX_BYTE_LABEL + 1;
        byte[] bytes = new byte[small ? n : 0];
        short[] shorts = new short[small ? 0 : n];
        int voxel = 0;
        for (int k = 0; k < size.slices(); k++) {
            int slice = nearest(k, size.slices(), grid.slices());
            for (int j = 0; j < size.rows(); j++) {
                int row = nearest(j, size.rows(), grid.rows());
                for (int i = 0; i < size.columns(); i++) {
                    int label = grid.label(nearest(i, size.columns(), grid.columns()), row, slice);
                    if (small) {
                        bytes[voxel++] = (byte) label;
                    } else {
                        shorts[voxel++] = (short) label;
                    }
                }
            }
        }
        double[] toMm = scaled(grid, size);
        return small
                ? LabelGrid.of(size.columns(), size.rows(), size.slices(), bytes, toMm)
                : LabelGrid.of(size.columns(), size.rows(), size.slices(), shorts, toMm);
    }

    private static int nearest(int index, int count, int ofCount) {
        return (int) ((index + 0.5) * ofCount / count);
    }

    private static double[] scaled(LabelGrid grid, ScanSize size) {
        double[] ratio = {
            (double) grid.columns() / size.columns(),
            (double) grid.rows() / size.rows(),
            (double) grid.slices() / size.slices()
        };
        double[] toMm = grid.toMm();
        for (int axis = 0; axis < 3; axis++) {
            for (int d = 0; d < 3; d++) {
                toMm[4 * axis + 3] += toMm[4 * axis + d] * (0.5 * ratio[d] - 0.5);
                toMm[4 * axis + d] *= ratio[d];
            }
        }
        return toMm;
    }
}
