package org.phrenic.patient.segmentation;

import java.util.Arrays;

/**
 * Walks from voxel to voxel across faces, within one part of a volume. It has a box of its own, one voxel wider all
 * round than the part, so that no step leads out of it: a cell of this box has a number of its own, by which all arrays
 * here go.
 */
final class VoxelRegion {
    /** Mark of pieces that are too small to be told apart. */
    static final byte SMALL_COMPONENT = 1;

    private static final short NOT_YET = Short.MAX_VALUE;
    /** Pieces of less than this share of the part are crumbs: fewer than 100 are not, so that a byte numbers them. */
    private static final int LEAST_SHARE = 100;

    private final Segmentation parts;
    /** First voxel of the part along columns, rows and slices. */
    private final int[] low;

    private final int wide;
    private final int high;
    private final int[] steps;
    /**
     * Steps from each cell of the part to the nearest one outside it; 0 outside, {@link #NOT_YET} where they are not
     * counted.
     */
    private final short[] depth;

    private final int[] queue;

    VoxelRegion(Segmentation parts, int part) {
        this.parts = parts;
        int[] box = parts.box(part);
        low = new int[] {box[0], box[1], box[2]};
        wide = box[3] - box[0] + 3;
        high = box[4] - box[1] + 3;
        steps = new int[] {-1, 1, -wide, wide, -wide * high, wide * high};
        depth = new short[wide * high * (box[5] - box[2] + 3)];
        int members = 0;
        for (int k = box[2]; k <= box[5]; k++) {
            for (int j = box[1]; j <= box[4]; j++) {
                int voxel = parts.columns * (j + parts.rows * k);
                int cell = 1 - box[0] + wide * (j - box[1] + 1 + high * (k - box[2] + 1));
                for (int i = box[0]; i <= box[3]; i++) {
                    if (parts.voxels[voxel + i] == (byte) part) {
                        depth[cell + i] = NOT_YET;
                        members++;
                    }
                }
            }
        }
        queue = new int[members];
    }

    /** How many cells the box has. */
    int cells() {
        return depth.length;
    }

    /** Whether a cell is of the part. */
    boolean isMember(int cell) {
        return depth[cell] != 0;
    }

    /** The voxel of a cell that is of the part. */
    int voxel(int cell) {
        int i = low[0] + cell % wide - 1;
        int j = low[1] + cell / wide % high - 1;
        int k = low[2] + cell / wide / high - 1;
        return i + parts.columns * (j + parts.rows * k);
    }

    /** Counts for each cell of the part the steps to the nearest one outside it. */
    void computeDepths() {
        int length = 0;
        for (int cell = 0; cell < depth.length; cell++) {
            boolean edge = false;
            for (int s = 0; s < 6 && depth[cell] != 0 && !edge; s++) {
                edge = depth[cell + steps[s]] == 0;
            }
            if (edge) {
                queue[length++] = cell;
            }
        }
        for (int at = 0; at < length; at++) {
            depth[queue[at]] = 1;
        }
        for (int at = 0; at < length; at++) {
            for (int step : steps) {
                int next = queue[at] + step;
                if (depth[next] == NOT_YET) {
                    depth[next] = (short) (depth[queue[at]] + 1);
                    queue[length++] = next;
                }
            }
        }
    }

    /**
     * Pieces of what lies deeper than a bound.
     *
     * @param marks gets the number of the piece of each cell, from 2, {@link #SMALL_COMPONENT} for small ones, 0
     *     elsewhere
     * @return sizes by number
     */
    int[] connectedComponents(int deeperThan, byte[] marks) {
        Arrays.fill(marks, (byte) 0);
        int[] sizes = new int[LEAST_SHARE + 2];
        int count = SMALL_COMPONENT;
        for (int seed = 0; seed < depth.length; seed++) {
            if (depth[seed] > deeperThan && marks[seed] == 0) {
                byte mark = (byte) (count + 1);
                marks[seed] = mark;
                queue[0] = seed;
                int length = 1;
                for (int at = 0; at < length; at++) {
                    for (int step : steps) {
                        int next = queue[at] + step;
                        if (depth[next] > deeperThan && marks[next] == 0) {
                            marks[next] = mark;
                            queue[length++] = next;
                        }
                    }
                }
                if ((long) LEAST_SHARE * length > queue.length) {
                    sizes[++count] = length;
                } else {
                    for (int at = 0; at < length; at++) {
                        marks[queue[at]] = SMALL_COMPONENT;
                    }
                }
            }
        }
        return Arrays.copyOf(sizes, count + 1);
    }

    /**
     * Gives each cell of the part the mark of the marked one that is fewest steps away; 0 stays where none leads there.
     */
    void growRegions(byte[] marks) {
        int length = 0;
        for (int cell = 0; cell < marks.length; cell++) {
            if (marks[cell] != 0) {
                queue[length++] = cell;
            }
        }
        for (int at = 0; at < length; at++) {
            for (int step : steps) {
                int next = queue[at] + step;
                if (depth[next] != 0 && marks[next] == 0) {
                    marks[next] = marks[queue[at]];
                    queue[length++] = next;
                }
            }
        }
    }
}
