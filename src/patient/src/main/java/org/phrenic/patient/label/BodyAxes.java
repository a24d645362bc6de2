package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Other axes for the coordinates that a file states, x to the left, y to the back and z up: a permutation of the
 * coordinates with signs. Coordinate {@code i} in the other axes is {@code sign[i]} times coordinate {@code from[i]}.
 */
final class BodyAxes {
    static final BodyAxes STATED = new BodyAxes(new int[] {0, 1, 2}, new int[] {1, 1, 1});
    /** Right and left exchanged. */
    static final BodyAxes MIRRORED = new BodyAxes(new int[] {0, 1, 2}, new int[] {-1, 1, 1});

    private static final String SIDES = "LRPASI";

    private final int[] from;
    private final int[] sign;

    private BodyAxes(int[] from, int[] sign) {
        this.from = from;
        this.sign = sign;
    }

    /** All 48 permutations with signs; the stated axes come first, then the mirrored ones. */
    static List<BodyAxes> all() {
        List<BodyAxes> all = new ArrayList<>(List.of(STATED, MIRRORED));
        int[][] orders = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        for (int[] order : orders) {
            for (int signs = order == orders[0] ? 2 : 0; signs < 8; signs++) {
                all.add(new BodyAxes(
                        order,
                        new int[] {(signs & 1) == 0 ? 1 : -1, (signs & 2) == 0 ? 1 : -1, (signs & 4) == 0 ? 1 : -1}));
            }
        }
        return all;
    }

    /**
     * The axes under which columns, rows and slices of a grid run to these sides of the body.
     *
     * @param letters one each of L or R, P or A, S or I; empty if they are others
     */
    static Optional<BodyAxes> of(LabelGrid grid, String letters) {
        int[] along = along(grid);
        int[] from = {-1, -1, -1};
        int[] sign = new int[3];
        for (int direction = 0; direction < 3; direction++) {
            int side = letters.length() == 3 ? SIDES.indexOf(letters.charAt(direction)) : -1;
            if (side < 0 || from[side / 2] >= 0) {
                return Optional.empty();
            }
            from[side / 2] = along[direction];
            sign[side / 2] = (side % 2 == 0 ? 1 : -1) * (grid.toMm()[4 * along[direction] + direction] > 0 ? 1 : -1);
        }
        return Optional.of(new BodyAxes(from, sign));
    }

    /** Coordinate (0, 1 or 2) of a vector in these axes. */
    double coordinate(double[] stated, int axis) {
        return sign[axis] * stated[from[axis]];
    }

    /** The coordinate of the stated axes that becomes this one. */
    int from(int axis) {
        return from[axis];
    }

    /** 1 or -1. */
    int sign(int axis) {
        return sign[axis];
    }

    /** Number of coordinates that stay what they are. */
    int unchanged() {
        int count = 0;
        for (int axis = 0; axis < 3; axis++) {
            count += from[axis] == axis && sign[axis] > 0 ? 1 : 0;
        }
        return count;
    }

    /** Whether a body in these axes is the mirror image of what it is in the stated ones. */
    boolean mirrors() {
        boolean odd = from[0] == 0 ? from[1] == 2 : from[0] == 1 ? from[1] == 0 : from[1] == 1;
        return odd == sign[0] * sign[1] * sign[2] > 0;
    }

    /** Sides of the body to which columns, rows and slices of a grid run in these axes, such as LPS. */
    String letters(LabelGrid grid) {
        int[] along = along(grid);
        StringBuilder letters = new StringBuilder();
        for (int direction = 0; direction < 3; direction++) {
            for (int axis = 0; axis < 3; axis++) {
                if (from[axis] == along[direction]) {
                    boolean positive = grid.toMm()[4 * from[axis] + direction] * sign[axis] > 0;
                    letters.append(SIDES.charAt(2 * axis + (positive ? 0 : 1)));
                }
            }
        }
        return letters.toString();
    }

    /** The coordinate along which each grid direction runs; the most parallel pair is taken first. */
    private static int[] along(LabelGrid grid) {
        double[] m = grid.toMm();
        int[] along = {-1, -1, -1};
        boolean[] taken = new boolean[3];
        for (int pair = 0; pair < 3; pair++) {
            int bestDirection = -1;
            int bestAxis = -1;
            double best = -1;
            for (int direction = 0; direction < 3; direction++) {
                for (int axis = 0; axis < 3; axis++) {
                    double cosine = Math.abs(m[4 * axis + direction]) / grid.spacing(direction);
                    if (along[direction] < 0 && !taken[axis] && cosine > best) {
                        best = cosine;
                        bestDirection = direction;
                        bestAxis = axis;
                    }
                }
            }
            along[bestDirection] = bestAxis;
            taken[bestAxis] = true;
        }
        return along;
    }
}
