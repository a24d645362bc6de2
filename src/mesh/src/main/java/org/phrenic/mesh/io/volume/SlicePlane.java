package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;

/**
 * The contours of a region in a slice. Those of the plane that is nearest to the slice count, and of other planes those
 * that lie beside all of these. A contour that lies over one of a nearer plane, or that comes again, is left out:
 * filled together by the even-odd rule, they would cancel.
 */
final class SlicePlane {
    /** Contours of one plane differ by less in height, slices. */
    private static final double SAME_PLANE = 0.1;

    private record Contour(double at, double[] corners) {
        /** Whether its box and another's have a place in common. */
        boolean isOver(Contour other) {
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
        OptionalDouble plane = nearestFirst.stream().mapToDouble(Contour::at).findFirst();
        for (Contour contour : nearestFirst) {
            boolean same = Math.abs(contour.at() - plane.getAsDouble()) < SAME_PLANE;
            boolean counts = same
                    ? kept.stream().noneMatch(other -> Arrays.equals(other.corners(), contour.corners()))
                    : kept.stream().noneMatch(contour::isOver);
            if (counts) {
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
