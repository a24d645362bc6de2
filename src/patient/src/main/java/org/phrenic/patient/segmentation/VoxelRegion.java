package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.mesh.IntList;

/**
 * Face-connected region growing within one segment. Cells are the voxels of the segment's bounding box plus a border of
 * one voxel, so that a step to a neighbour never leaves the array. Arrays are indexed by cell.
 */
final class VoxelRegion {
    /** Mark of components that are too small to receive a number. */
    static final byte SMALL_COMPONENT = 1;

    private static final short UNKNOWN = Short.MAX_VALUE;
    /** Components smaller than the segment divided by this value are not numbered, so that numbers fit into a byte. */
    private static final int MAX_COMPONENTS = 100;
    /** Voxels that the border adds to each side of the bounding box. */
    private static final int BORDER = 2;

    private final Segmentation segmentation;
    /** First column, row and slice of the bounding box. */
    private final int[] low;

    private final int wide;
    private final int high;
    private final int[] steps;
    /** As {@link #computeDepths} tells; 0 outside the segment, {@link #UNKNOWN} before computation. */
    private final short[] depth;

    private final int[] queue;

    /** Prepares a segment; one without voxels has no member. */
    VoxelRegion(Segmentation segmentation, int segment) {
        this.segmentation = segmentation;
        int[] box = segmentation.box(segment);
        low = new int[] {box[0], box[1], box[2]};
        wide = size(box, 0);
        high = size(box, 1);
        steps = new int[] {-1, 1, -wide, wide, -wide * high, wide * high};
        depth = new short[wide * high * size(box, 2)];
        int members = 0;
        for (int k = box[2]; k <= box[5]; k++) {
            for (int j = box[1]; j <= box[4]; j++) {
                int voxel = segmentation.columns * (j + segmentation.rows * k);
                int cell = 1 - box[0] + wide * (j - box[1] + 1 + high * (k - box[2] + 1));
                for (int i = box[0]; i <= box[3]; i++) {
                    if (segmentation.voxels[voxel + i] == (byte) segment) {
                        depth[cell + i] = UNKNOWN;
                        members++;
                    }
                }
            }
        }
        queue = new int[members];
    }

    private static int size(int[] box, int direction) {
        return Math.max(0, box[3 + direction] - box[direction] + 1) + BORDER;
    }

    /** Number of cells. */
    int cells() {
        return depth.length;
    }

    /** Whether a cell belongs to the segment. */
    boolean isMember(int cell) {
        return depth[cell] != 0;
    }

    /** Voxel index of a cell of the segment. */
    int voxel(int cell) {
        int i = low[0] + cell % wide - 1;
        int j = low[1] + cell / wide % high - 1;
        int k = low[2] + cell / wide / high - 1;
        return i + segmentation.columns * (j + segmentation.rows * k);
    }

    /**
     * Computes the depth of each cell: the least distance along the axes from a cell outside the segment, in voxels of
     * the smallest spacing.
     */
    void computeDepths() {
        double[] spacings =
                IntStream.range(0, 3).mapToDouble(segmentation.grid()::spacing).toArray();
        double least = Arrays.stream(spacings).min().orElseThrow();
        int[] lengths = Arrays.stream(spacings)
                .mapToInt(spacing -> (int) Math.round(spacing / least))
                .toArray();
        for (int cell = 0; cell < depth.length; cell++) {
            deepen(cell, 0, lengths);
        }
        for (int cell = depth.length - 1; cell >= 0; cell--) {
            deepen(cell, 1, lengths);
        }
    }

    /** @param first of the steps backward or forward */
    private void deepen(int cell, int first, int[] lengths) {
        for (int axis = 0; axis < 3 && depth[cell] != 0; axis++) {
            int beyond = depth[cell + steps[2 * axis + first]] + lengths[axis];
            depth[cell] = (short) Math.min(depth[cell], beyond);
        }
    }

    /**
     * Finds connected components of the cells deeper than a bound.
     *
     * @param marks receives the component number of each cell: from 2, {@link #SMALL_COMPONENT} for small components, 0
     *     elsewhere
     * @return component sizes by number
     */
    int[] connectedComponents(int deeperThan, byte[] marks) {
        Arrays.fill(marks, (byte) 0);
        int[] sizes = new int[MAX_COMPONENTS + 2];
        int count = SMALL_COMPONENT;
        for (int seed = 0; seed < depth.length; seed++) {
            if (depth[seed] > deeperThan && marks[seed] == 0) {
                marks[seed] = (byte) (count + 1);
                queue[0] = seed;
                int length = spread(1, deeperThan, marks);
                if ((long) MAX_COMPONENTS * length > queue.length) {
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

    /** Cells of each connected component that bears no mark and has at least so many cells, the largest first. */
    List<IntList> unmarkedComponents(byte[] marks, int leastCells) {
        byte[] seen = marks.clone();
        List<IntList> components = new ArrayList<>();
        for (int seed = 0; seed < depth.length; seed++) {
            if (depth[seed] > 0 && seen[seed] == 0) {
                seen[seed] = SMALL_COMPONENT;
                queue[0] = seed;
                int length = spread(1, 0, seen);
                if (length >= leastCells) {
                    IntList cells = new IntList();
                    Arrays.stream(queue, 0, length).forEach(cells::add);
                    components.add(cells);
                }
            }
        }
        components.sort(Comparator.comparingInt(IntList::size).reversed());
        return components;
    }

    /** Number of cells of the segment. */
    int memberCount() {
        return queue.length;
    }

    /** Gives the cells of a mark to another segment. */
    void assign(byte[] marks, int mark, int segment) {
        for (int cell = 0; cell < marks.length; cell++) {
            if (marks[cell] == mark) {
                segmentation.voxels[voxel(cell)] = (byte) segment;
            }
        }
    }

    /** Assigns each cell the mark of the nearest marked cell, in steps. Cells not connected to a marked cell keep 0. */
    void growRegions(byte[] marks) {
        int length = 0;
        for (int cell = 0; cell < marks.length; cell++) {
            if (marks[cell] != 0) {
                queue[length++] = cell;
            }
        }
        spread(length, 0, marks);
    }

    /** Spreads marks from queued cells to unmarked cells deeper than a bound. Returns the final length of the queue. */
    private int spread(int queued, int deeperThan, byte[] marks) {
        int length = queued;
        for (int at = 0; at < length; at++) {
            for (int step : steps) {
                int next = queue[at] + step;
                if (depth[next] > deeperThan && marks[next] == 0) {
                    marks[next] = marks[queue[at]];
                    queue[length++] = next;
                }
            }
        }
        return length;
    }
}
