package org.phrenic.patient.label;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Label numbers that were interpolated linearly, as an image is: at each border between two structures lies a layer of
 * the numbers between, which are those of other structures. Three voxels in a row rise or fall there all the way.
 */
public final class InterpolatedLabels {
    /** Share of such rows of three among those whose ends differ; segmentations have less than 0.01. */
    private static final double MOST = 0.1;
    /** Greatest share of one number in the middle: a thin shell, as of skin, has one. */
    private static final double MOST_OF_ONE = 0.6;
    /** Least share of the voxels of a number with neighbours of that number alone, of a structure that is no shell. */
    private static final double LEAST_INNER = 0.5;

    private InterpolatedLabels() {}

    /** What is found and expected, without a full stop, if the labels were interpolated. */
    public static Optional<String> problem(LabelGrid grid) {
        long[] middle = new long[LabelGrid.MAX_LABEL + 1];
        long borders = count(grid, middle);
        long between = Arrays.stream(middle).sum();
        boolean many = between > MOST * borders;
        long ofOne = Arrays.stream(middle).max().orElse(0);
        return many
                        && (ofOne < MOST_OF_ONE * between
                                || isSolid(
                                        grid,
                                        IntStream.range(0, middle.length)
                                                .filter(label -> middle[label] == ofOne)
                                                .findFirst()
                                                .orElseThrow()))
                ? Optional.of(Numbers.format(
                        "found layers of numbers between those of two structures at %.0f %% of the borders, as of"
                                + " labels that were interpolated linearly, expected each voxel with the label of the"
                                + " nearest one",
                        100.0 * between / borders))
                : Optional.empty();
    }

    /** Whether most voxels of a number lie in its inside, as of a lung whose number is that of a shell as well. */
    private static boolean isSolid(LabelGrid grid, int label) {
        int[] steps = {1, grid.columns(), grid.columns() * grid.rows()};
        long inner = IntStream.range(steps[2], grid.voxelCount() - steps[2])
                .filter(v -> grid.label(v) == label)
                .filter(v -> Arrays.stream(steps)
                        .allMatch(step -> grid.label(v - step) == label && grid.label(v + step) == label))
                .count();
        return inner > LEAST_INNER * grid.counts()[label];
    }

    /**
     * Number of rows of three voxels whose ends differ.
     *
     * @param middle receives, by the number in the middle, how many of them rise or fall all the way
     */
    private static long count(LabelGrid grid, long[] middle) {
        int columns = grid.columns();
        int slice = columns * grid.rows();
        int[] steps = {1, columns, slice};
        boolean[] inside = new boolean[3];
        long borders = 0;
        for (int k = 0; k < grid.slices(); k++) {
            inside[2] = k > 0 && k < grid.slices() - 1;
            for (int j = 0; j < grid.rows(); j++) {
                inside[1] = j > 0 && j < grid.rows() - 1;
                for (int i = 0; i < columns; i++) {
                    int v = i + columns * j + slice * k;
                    inside[0] = i > 0 && i < columns - 1;
                    int own = grid.label(v);
                    for (int axis = 0; axis < 3; axis++) {
                        if (inside[axis]) {
                            int before = grid.label(v - steps[axis]);
                            int after = grid.label(v + steps[axis]);
                            borders += before == after ? 0 : 1;
                            middle[own] += (long) (own - before) * (after - own) > 0 ? 1 : 0;
                        }
                    }
                }
            }
        }
        return borders;
    }
}
