package org.phrenic.patient.segmentation;

import java.util.Arrays;
import java.util.List;

/** Boxes of the pieces of a bone, which tell those too far from the largest for any chain of bridges. */
final class PieceBoxes {
    private final boolean[] near;
    /** First column, row and slice within reach of the near pieces, then last ones; may lie beyond the volume. */
    private final int[] reached;

    /**
     * @param pieces lists of voxels, the largest first
     * @param reachMm greatest length of a bridge, mm
     */
    PieceBoxes(Segmentation s, List<int[]> pieces, double reachMm) {
        int[] reach = new int[3];
        Arrays.setAll(reach, axis -> 1 + (int) Math.ceil(reachMm / s.grid().spacing(axis)));
        int[][] boxes = pieces.stream().map(piece -> box(s, piece)).toArray(int[][]::new);
        near = new boolean[boxes.length];
        reached = boxes[0].clone();
        grow(boxes[0], reach);
        near[0] = true;
        boolean grown = true;
        while (grown) {
            grown = false;
            for (int piece = 1; piece < boxes.length; piece++) {
                if (!near[piece] && meets(boxes[piece])) {
                    near[piece] = true;
                    grow(boxes[piece], reach);
                    grown = true;
                }
            }
        }
    }

    private static int[] box(Segmentation s, int[] piece) {
        int[] box = {s.columns, s.rows, s.slices, -1, -1, -1};
        for (int v : piece) {
            int[] at = {v % s.columns, v / s.columns % s.rows, v / s.columns / s.rows};
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = Math.min(box[axis], at[axis]);
                box[3 + axis] = Math.max(box[3 + axis], at[axis]);
            }
        }
        return box;
    }

    private void grow(int[] box, int[] reach) {
        for (int axis = 0; axis < 3; axis++) {
            reached[axis] = Math.min(reached[axis], box[axis] - reach[axis]);
            reached[3 + axis] = Math.max(reached[3 + axis], box[3 + axis] + reach[axis]);
        }
    }

    private boolean meets(int[] box) {
        boolean meets = true;
        for (int axis = 0; axis < 3; axis++) {
            meets &= box[axis] <= reached[3 + axis] && box[3 + axis] >= reached[axis];
        }
        return meets;
    }

    boolean isNear(int piece) {
        return near[piece];
    }

    int[] reached() {
        return reached;
    }
}
