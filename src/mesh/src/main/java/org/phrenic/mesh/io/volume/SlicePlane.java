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

    private record Contour(double at, double[] corners) {
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
                double least = -extreme(axis, -1);
                double otherLeast = -other.extreme(axis, -1);
                common *= Math.min(extreme(axis, 1), other.extreme(axis, 1)) - Math.max(least, otherLeast);
                both *= Math.max(extreme(axis, 1), other.extreme(axis, 1)) - Math.min(least, otherLeast);
            }
            return isOver(other) && common > SAME_OUTLINE * both;
        }

        /** Whether its box and another's have a place in common. */
        private boolean isOver(Contour other) {
            return overlaps(other, 0) && overlaps(other, 1);
        }

        private boolean overlaps(Contour other, int axis) {
            return extreme(axis, 1) >= -other.extreme(axis, -1) && other.extreme(axis, 1) >= -extreme(axis, -1);
        }

        /** The greatest coordinate along an axis times a sign. */
        private double extreme(int axis, int sign) {
            double greatest = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < corners.length; i += 2) {
                greatest = Math.max(greatest, sign * corners[i]);
            }
            return greatest;
        }
    }

    private final List<Contour> all = new ArrayList<>();

    /**
     * @param at height of the contour above the slice, slices
     * @param corners in columns and rows
     */
    void add(double at, double[] corners) {
        all.add(new Contour(at, corners));
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

    /** Number of contours that are left out. */
    int leftOut() {
        return all.size() - contours().size();
    }
}
