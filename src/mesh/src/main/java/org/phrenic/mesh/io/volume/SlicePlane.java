package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The contours of a region in the plane that is nearest to a slice. Contours of other planes of the slice are left out,
 * and so is a contour that comes again: filled together by the even-odd rule, they would cancel.
 */
final class SlicePlane {
    /** Contours of one plane differ by less in height, slices. */
    private static final double SAME_PLANE = 0.01;

    private final List<double[]> contours = new ArrayList<>();
    private double offset = Double.POSITIVE_INFINITY;
    private int leftOut;

    /**
     * @param at height of the contour above the slice, slices
     * @param corners in columns and rows
     */
    void add(double at, double[] corners) {
        boolean same = Math.abs(at - offset) < SAME_PLANE;
        boolean isLeftOut = same
                ? contours.stream().anyMatch(other -> Arrays.equals(other, corners))
                : Math.abs(at) >= Math.abs(offset);
        if (isLeftOut) {
            leftOut++;
            return;
        }
        if (!same) {
            leftOut += contours.size();
            contours.clear();
            offset = at;
        }
        contours.add(corners);
    }

    List<double[]> contours() {
        return contours;
    }

    /** Number of contours that were left out. */
    int leftOut() {
        return leftOut;
    }
}
