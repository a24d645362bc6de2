package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * The contours of a region in a slice, of which those of a plane nearer to the slice come first. A contour that lies
 * over one of a nearer plane, or that comes again, is left out: filled together by the even-odd rule, they would
 * cancel.
 */
final class SlicePlane {
    /** Contours of one plane differ by less in height, slices. */
    private static final double SAME_PLANE = 0.1;

    /** Contours of one drawing of a plane differ by less in height, by rounding, slices. */
    private static final double ROUNDING = 0.01;
    /** Share of the box about two contours that their boxes have in common if one follows the other. */
    private static final double SAME_OUTLINE = 0.6;

    /**
     * A contour.
     *
     * @param at height above the slice, slices
     * @param low lowest column and row
     * @param high highest column and row
     */
    private record Contour(double at, double[] corners, double[] low, double[] high) {
        static Contour of(double at, double[] corners) {
            double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
            double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
            for (int i = 0; i < corners.length; i++) {
                low[i % 2] = Math.min(low[i % 2], corners[i]);
                high[i % 2] = Math.max(high[i % 2], corners[i]);
            }
            return new Contour(at, corners, low, high);
        }

        /** Whether it would cancel with another of the slice where both are filled. */
        boolean cancels(Contour kept) {
            double apart = Math.abs(at - kept.at);
            if (apart >= SAME_PLANE) {
                return isOver(kept);
            }
            return Arrays.equals(corners, kept.corners) || (apart > ROUNDING && follows(kept));
        }

        /** Whether it is nearly the same outline as another, as that of the next plane is, and not a hole in it. */
        private boolean follows(Contour other) {
            double common = 1;
            double both = 1;
            for (int axis = 0; axis < 2; axis++) {
                common *= Math.min(high[axis], other.high[axis]) - Math.max(low[axis], other.low[axis]);
                both *= Math.max(high[axis], other.high[axis]) - Math.min(low[axis], other.low[axis]);
            }
            return isOver(other) && common > SAME_OUTLINE * both;
        }

        /** Whether its box and another's have a place in common. */
        private boolean isOver(Contour other) {
            return high[0] >= other.low[0]
                    && other.high[0] >= low[0]
                    && high[1] >= other.low[1]
                    && other.high[1] >= low[1];
        }
    }

    private final List<Contour> all = new ArrayList<>();

    /**
     * @param at height of the contour above the slice, slices
     * @param corners in columns and rows
     */
    void add(double at, double[] corners) {
        all.add(Contour.of(at, corners));
    }

    /** Corners of the contours that count. */
    List<double[]> contours() {
        List<Contour> kept = new ArrayList<>();
        List<Contour> nearestFirst = all.stream()
                .sorted(Comparator.comparingDouble(contour -> Math.abs(contour.at())))
                .toList();
        for (Contour contour : nearestFirst) {
            if (kept.stream().noneMatch(contour::cancels)) {
                kept.add(contour);
            }
        }
        return kept.stream().map(Contour::corners).toList();
    }

    /** Number of contours, with those that do not count. */
    int size() {
        return all.size();
    }
}
