package org.phrenic.patient.segmentation;

import java.util.BitSet;
import java.util.List;

/** Which points lie within {@value #NEAR_MM} mm of the voxels of some segments, to about {@value #CELL_MM} mm. */
public final class NearVoxels {
    private static final double NEAR_MM = 22;
    private static final double CELL_MM = 4;

    private final double[] low = new double[3];
    private final int[] size = new int[3];
    private final BitSet cells;

    public NearVoxels(Segmentation s, List<Integer> segments) {
        double[] high = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
            for (int corner = 0; corner < 8; corner++) {
                int v = (corner & 1) * (s.columns - 1)
                        + s.columns * ((corner >> 1 & 1) * (s.rows - 1) + s.rows * (corner >> 2) * (s.slices - 1));
                low[axis] = Math.min(low[axis], s.coordinate(v, axis));
                high[axis] = Math.max(high[axis], s.coordinate(v, axis));
            }
            size[axis] = (int) ((high[axis] - low[axis]) / CELL_MM) + 1;
        }
        cells = new BitSet(size[0] * size[1] * size[2]);
        boolean[] wanted = new boolean[s.names().size() + 1];
        segments.forEach(segment -> wanted[segment] = segment > 0);
        for (int v = 0; v < s.voxels.length; v++) {
            if (wanted[s.segmentAt(v)]) {
                double[] p = s.point(v);
                cells.set(cell(index(p, 0), index(p, 1), index(p, 2)));
            }
        }
    }

    private int index(double[] p, int axis) {
        return (int) Math.floor((p[axis] - low[axis]) / CELL_MM);
    }

    private int cell(int i, int j, int k) {
        return i + size[0] * (j + size[1] * k);
    }

    public boolean isNear(double[] p) {
        int reach = (int) (NEAR_MM / CELL_MM);
        double most = NEAR_MM * NEAR_MM / (CELL_MM * CELL_MM);
        int[] at = {index(p, 0), index(p, 1), index(p, 2)};
        for (int k = Math.max(0, at[2] - reach); k <= Math.min(size[2] - 1, at[2] + reach); k++) {
            for (int j = Math.max(0, at[1] - reach); j <= Math.min(size[1] - 1, at[1] + reach); j++) {
                for (int i = Math.max(0, at[0] - reach); i <= Math.min(size[0] - 1, at[0] + reach); i++) {
                    int square = (i - at[0]) * (i - at[0]) + (j - at[1]) * (j - at[1]) + (k - at[2]) * (k - at[2]);
                    if (square <= most && cells.get(cell(i, j, k))) {
                        return true;
                    }
                }
            }
        }
        return false;
    }
}
