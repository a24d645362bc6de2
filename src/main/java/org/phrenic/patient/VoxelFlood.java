package org.phrenic.patient;

import java.util.Arrays;

/** Walks from voxel to voxel across faces, within one part of a volume. */
final class VoxelFlood {
    private static final int NONE = -1;

    private final Parts parts;
    private final byte part;
    private final int[] queue;

    VoxelFlood(Parts parts, int part) {
        this.parts = parts;
        this.part = (byte) part;
        queue = new int[parts.voxels.length];
    }

    /** The neighbour of a voxel in one of six directions, -1 beyond the box. */
    int neighbour(int voxel, int direction) {
        int axis = direction >> 1;
        int step = (direction & 1) == 0 ? -1 : 1;
        int at = axis == 0
                ? voxel % parts.columns
                : axis == 1 ? voxel / parts.columns % parts.rows : voxel / parts.columns / parts.rows;
        int size = axis == 0 ? parts.columns : axis == 1 ? parts.rows : parts.slices;
        int stride = axis == 0 ? 1 : axis == 1 ? parts.columns : parts.columns * parts.rows;
        return at + step < 0 || at + step >= size ? NONE : voxel + step * stride;
    }

    /** Steps from each voxel of the part to the nearest one outside it; 0 outside. */
    int[] depth() {
        int[] depth = new int[parts.voxels.length];
        int length = 0;
        for (int v = 0; v < depth.length; v++) {
            boolean edge = false;
            for (int d = 0; d < 6 && parts.voxels[v] == part && !edge; d++) {
                int n = neighbour(v, d);
                edge = n == NONE || parts.voxels[n] != part;
            }
            if (edge) {
                depth[v] = 1;
                queue[length++] = v;
            }
        }
        for (int at = 0; at < length; at++) {
            for (int d = 0; d < 6; d++) {
                int n = neighbour(queue[at], d);
                if (n != NONE && parts.voxels[n] == part && depth[n] == 0) {
                    depth[n] = depth[queue[at]] + 1;
                    queue[length++] = n;
                }
            }
        }
        return depth;
    }

    /** Pieces of what lies deeper than a bound: number of the piece of each voxel from 1, 0 elsewhere; sizes by number. */
    int[] pieces(int[] depth, int deeperThan, int[] pieceOf) {
        Arrays.fill(pieceOf, 0);
        int[] sizes = new int[16];
        int count = 0;
        for (int v = 0; v < depth.length; v++) {
            if (depth[v] > deeperThan && pieceOf[v] == 0) {
                count++;
                sizes = count < sizes.length ? sizes : Arrays.copyOf(sizes, 2 * count);
                pieceOf[v] = count;
                queue[0] = v;
                int length = 1;
                for (int at = 0; at < length; at++) {
                    for (int d = 0; d < 6; d++) {
                        int n = neighbour(queue[at], d);
                        if (n != NONE && depth[n] > deeperThan && pieceOf[n] == 0) {
                            pieceOf[n] = count;
                            queue[length++] = n;
                        }
                    }
                }
                sizes[count] = length;
            }
        }
        return Arrays.copyOf(sizes, count + 1);
    }

    /** Gives each voxel of the part the mark of the marked one that is fewest steps away; 0 stays where none leads there. */
    void spread(int[] marks) {
        int length = 0;
        for (int v = 0; v < marks.length; v++) {
            if (marks[v] != 0) {
                queue[length++] = v;
            }
        }
        for (int at = 0; at < length; at++) {
            for (int d = 0; d < 6; d++) {
                int n = neighbour(queue[at], d);
                if (n != NONE && parts.voxels[n] == part && marks[n] == 0) {
                    marks[n] = marks[queue[at]];
                    queue[length++] = n;
                }
            }
        }
    }
}
