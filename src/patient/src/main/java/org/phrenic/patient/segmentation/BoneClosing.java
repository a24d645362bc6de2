package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.mesh.IntList;

/**
 * Morphological closing of bones and cartilages: a dilation by a box followed by an erosion by the same box. It fills
 * pits, dropped voxels and gaps of up to about 3 mm, along directions of larger spacing than 1.5 mm those of up to two
 * voxels, and keeps thin bones. Only background is filled, and what fills the space between organs like it.
 */
final class BoneClosing {
    /** Distance from the middle voxel of the box to its last along each grid direction, mm; at least one voxel. */
    private static final double REACH_MM = 1.5;
    /** Directions with larger spacing are not closed: there a gap of a voxel is a gap between two bones. */
    private static final double MAX_SPACING_MM = 3.5;

    private BoneClosing() {}

    /**
     * Closes segments; returns the number of voxels filled. A voxel goes to the first segment that fills it.
     *
     * @param free by segment number, whether its voxels may be filled
     */
    static int close(Segmentation segmentation, List<Integer> segments, boolean[] free) {
        int[] reach = IntStream.range(0, 3)
                .map(direction -> {
                    double spacing = segmentation.grid().spacing(direction);
                    return spacing > MAX_SPACING_MM ? 0 : Math.max(1, (int) Math.round(REACH_MM / spacing));
                })
                .toArray();
        int[][] boxes = segmentation.boxes();
        List<int[]> added = segments.parallelStream()
                .map(segment -> {
                    IntList all = new IntList();
                    for (int[] box : parts(segmentation, segment, boxes[segment], 2 * reach[2] + 1)) {
                        addVoxels(segmentation, segment, box, reach, free, all);
                    }
                    return all.toArray();
                })
                .toList();
        int filled = 0;
        for (int i = 0; i < added.size(); i++) {
            for (int voxel : added.get(i)) {
                if (free[segmentation.segmentAt(voxel)]) {
                    segmentation.voxels[voxel] = (byte) (int) segments.get(i);
                    filled++;
                }
            }
        }
        return filled;
    }

    /**
     * Boxes of the parts of a segment between which so many slices and more are empty: a stray part far away takes no
     * memory for what lies between.
     *
     * @param box of the segment
     */
    private static List<int[]> parts(Segmentation s, int segment, int[] box, int apart) {
        List<int[]> parts = new ArrayList<>();
        int[] part = box;
        for (int k = box[2]; k <= box[5]; k++) {
            for (int j = box[1]; j <= box[4]; j++) {
                int row = s.columns * (j + s.rows * k);
                for (int i = box[0]; i <= box[3]; i++) {
                    if (s.voxels[row + i] != (byte) segment) {
                        continue;
                    }
                    if (parts.isEmpty() || k - part[5] > apart) {
                        part = new int[] {i, j, k, i, j, k};
                        parts.add(part);
                    }
                    part[0] = Math.min(part[0], i);
                    part[1] = Math.min(part[1], j);
                    part[3] = Math.max(part[3], i);
                    part[4] = Math.max(part[4], j);
                    part[5] = k;
                }
            }
        }
        return parts;
    }

    /** Adds the free voxels in the closing of a part of a segment to a list. */
    private static void addVoxels(Segmentation s, int segment, int[] box, int[] reach, boolean[] free, IntList added) {
        int[] size = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            size[axis] = box[3 + axis] - box[axis] + 1 + 2 * reach[axis];
        }
        byte[] mask = new byte[size[0] * size[1] * size[2]];
        for (int k = box[2]; k <= box[5]; k++) {
            for (int j = box[1]; j <= box[4]; j++) {
                int voxel = s.columns * (j + s.rows * k);
                int cell = reach[0] - box[0] + size[0] * (j - box[1] + reach[1] + size[1] * (k - box[2] + reach[2]));
                for (int i = box[0]; i <= box[3]; i++) {
                    mask[cell + i] = (byte) (s.voxels[voxel + i] == (byte) segment ? 1 : 0);
                }
            }
        }
        for (byte value = 1; value >= 0; value--) {
            for (int axis = 0; axis < 3; axis++) {
                spread(mask, size, axis, reach[axis], value);
            }
        }
        for (int k = box[2]; k <= box[5]; k++) {
            for (int j = box[1]; j <= box[4]; j++) {
                int voxel = s.columns * (j + s.rows * k);
                int cell = reach[0] - box[0] + size[0] * (j - box[1] + reach[1] + size[1] * (k - box[2] + reach[2]));
                for (int i = box[0]; i <= box[3]; i++) {
                    if (mask[cell + i] == 1 && free[s.segmentAt(voxel + i)]) {
                        added.add(voxel + i);
                    }
                }
            }
        }
    }

    /** Sets the cells within {@code reach} of a cell with this value, along one axis. Outside the box lie zeros. */
    private static void spread(byte[] mask, int[] size, int axis, int reach, byte value) {
        if (reach == 0) {
            return;
        }
        int stride = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
        int length = size[axis];
        byte[] line = new byte[length];
        for (int index = 0; index < mask.length / length; index++) {
            int start = index / stride * stride * length + index % stride;
            int last = value == 0 ? -1 : -length - reach;
            int next = 0;
            for (int at = 0; at < length; at++) {
                while (next <= at + reach && next < length) {
                    last = mask[start + next * stride] == value ? next : last;
                    next++;
                }
                boolean near = last >= at - reach || (value == 0 && at + reach >= length);
                line[at] = near ? value : (byte) (1 - value);
            }
            for (int at = 0; at < length; at++) {
                mask[start + at * stride] = line[at];
            }
        }
    }
}
