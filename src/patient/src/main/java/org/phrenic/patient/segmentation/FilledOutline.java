package org.phrenic.patient.segmentation;

import java.util.stream.IntStream;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * The body within its skin: the union of all segments, and what these enclose in a layer across the body, as where the
 * skin is labelled as a shell. The ends of a scan above and below do not open a layer.
 */
public final class FilledOutline {
    private final int[] sizes;
    private final byte[] inside;

    private FilledOutline(int[] sizes, byte[] inside) {
        this.sizes = sizes;
        this.inside = inside;
    }

    /**
     * The body as label 1.
     *
     * @param times factors by which voxels are enlarged, for columns, rows and slices
     */
    public static LabelGrid of(Segmentation body, int[] times) {
        int[] sizes = {
            (body.columns - 1) / times[0] + 1, (body.rows - 1) / times[1] + 1, (body.slices - 1) / times[2] + 1
        };
        byte[] any = new byte[sizes[0] * sizes[1] * sizes[2]];
        for (int cell = 0; cell < any.length; cell++) {
            // Samples at the middle of each large voxel.
            int i = Math.min(body.columns - 1, times[0] * (cell % sizes[0]) + times[0] / 2);
            int j = Math.min(body.rows - 1, times[1] * (cell / sizes[0] % sizes[1]) + times[1] / 2);
            int k = Math.min(body.slices - 1, times[2] * (cell / sizes[0] / sizes[1]) + times[2] / 2);
            any[cell] = (byte) (body.voxels[i + body.columns * (j + body.rows * k)] == 0 ? 0 : 1);
        }
        double[] toMm = body.grid().toMm();
        double[] large = toMm.clone();
        for (int row = 0; row < 3; row++) {
            for (int direction = 0; direction < 3; direction++) {
                large[4 * row + direction] *= times[direction];
                int middle = times[direction] / 2;
                large[4 * row + 3] += middle * toMm[4 * row + direction];
            }
        }
        new FilledOutline(sizes, any)
                .fill(IntStream.range(0, 3)
                        .filter(body::isAlongBody)
                        .findFirst()
                        .orElse(2));
        return LabelGrid.of(sizes[0], sizes[1], sizes[2], any, large);
    }

    /** Fills the background of each layer across a direction that no path in the layer joins to the layer's border. */
    private void fill(int direction) {
        int[] strides = {1, sizes[0], sizes[0] * sizes[1]};
        int one = (direction + 1) % 3;
        int two = (direction + 2) % 3;
        for (int layer = 0; layer < sizes[direction]; layer++) {
            boolean[] outside = new boolean[sizes[one] * sizes[two]];
            IntList open = new IntList();
            for (int cell = 0; cell < outside.length; cell++) {
                int a = cell % sizes[one];
                int b = cell / sizes[one];
                if (a == 0 || b == 0 || a == sizes[one] - 1 || b == sizes[two] - 1) {
                    reach(cell, layer * strides[direction] + a * strides[one] + b * strides[two], outside, open);
                }
            }
            for (int next = 0; next < open.size(); next++) {
                int a = open.get(next) % sizes[one];
                int b = open.get(next) / sizes[one];
                for (int step = 0; step < 4; step++) {
                    int na = a + (step == 0 ? 1 : step == 1 ? -1 : 0);
                    int nb = b + (step == 2 ? 1 : step == 3 ? -1 : 0);
                    if (na >= 0 && nb >= 0 && na < sizes[one] && nb < sizes[two]) {
                        int at = layer * strides[direction] + na * strides[one] + nb * strides[two];
                        reach(na + sizes[one] * nb, at, outside, open);
                    }
                }
            }
            for (int cell = 0; cell < outside.length; cell++) {
                if (!outside[cell]) {
                    int a = cell % sizes[one];
                    int b = cell / sizes[one];
                    inside[layer * strides[direction] + a * strides[one] + b * strides[two]] = 1;
                }
            }
        }
    }

    private void reach(int cell, int at, boolean[] outside, IntList open) {
        if (!outside[cell] && inside[at] == 0) {
            outside[cell] = true;
            open.add(cell);
        }
    }
}
