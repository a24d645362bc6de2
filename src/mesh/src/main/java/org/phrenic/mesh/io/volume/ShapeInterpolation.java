package org.phrenic.mesh.io.volume;

import java.util.function.IntConsumer;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.DistanceTransform;

/**
 * Shape-based interpolation between the cross-sections of a structure in two slices (Raya and Udupa 1990, doi
 * 10.1109/42.52980): between them, the signed distance from the outline is interpolated linearly, and a pixel is inside
 * where it is positive. Pixels are squares.
 */
final class ShapeInterpolation {
    private final int columns;
    private final int firstColumn;
    private final int firstRow;
    private final int boxColumns;
    private final int boxRows;
    private final float[] before;
    private final float[] after;

    /**
     * Measures the distances.
     *
     * @param before pixels of a cross-section, column + columns row; at least one
     * @param after pixels of the other one
     * @param columns of the slices
     */
    ShapeInterpolation(IntList before, IntList after, int columns) {
        this.columns = columns;
        int[] box = {Integer.MAX_VALUE, Integer.MAX_VALUE, -1, -1};
        extend(box, before);
        extend(box, after);
        // One empty pixel around both.
        firstColumn = box[0] - 1;
        firstRow = box[1] - 1;
        boxColumns = box[2] - firstColumn + 2;
        boxRows = box[3] - firstRow + 2;
        this.before = signedDistances(before);
        this.after = signedDistances(after);
    }

    private void extend(int[] box, IntList pixels) {
        for (int i = 0; i < pixels.size(); i++) {
            int column = pixels.get(i) % columns;
            int row = pixels.get(i) / columns;
            box[0] = Math.min(box[0], column);
            box[1] = Math.min(box[1], row);
            box[2] = Math.max(box[2], column);
            box[3] = Math.max(box[3], row);
        }
    }

    /** Distance of each pixel of the box from the outline, in pixels; positive inside. */
    private float[] signedDistances(IntList pixels) {
        boolean[] inside = new boolean[boxColumns * boxRows];
        for (int i = 0; i < pixels.size(); i++) {
            int row = pixels.get(i) / columns - firstRow;
            inside[pixels.get(i) % columns - firstColumn + boxColumns * row] = true;
        }
        float[] signed = DistanceTransform.signed(inside, new int[] {boxColumns, boxRows, 1});
        for (int p = 0; p < signed.length; p++) {
            // The outline runs halfway between a pixel inside and its neighbour outside.
            signed[p] = (inside[p] ? -0.5f : 0.5f) - signed[p];
        }
        return signed;
    }

    /** Whether the cross-sections have a pixel in common. */
    boolean overlap() {
        for (int p = 0; p < before.length; p++) {
            if (before[p] > 0 && after[p] > 0) {
                return true;
            }
        }
        return false;
    }

    /**
     * Gives the pixels of the cross-section between both.
     *
     * @param share of the distance from the first to the second, 0 to 1
     */
    void between(double share, IntConsumer use) {
        for (int p = 0; p < before.length; p++) {
            if ((1 - share) * before[p] + share * after[p] > 0) {
                use.accept(firstColumn + p % boxColumns + columns * (firstRow + p / boxColumns));
            }
        }
    }
}
