package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;

/** Squares of 10 x 10 mm in axial planes at these heights. */
class ContourGridTest {
    private static SliceGrid grid(double... heights) {
        List<double[]> squares = Arrays.stream(heights)
                .mapToObj(z -> new double[] {0, 0, z, 10, 0, z, 10, 10, z, 0, 10, z})
                .toList();
        return new ContourGrid("contours", List.of(squares)).grid();
    }

    private static void assertSlices(SliceGrid grid, int slices, double apart) {
        assertThat(grid.slices()).isEqualTo(slices);
        assertThat(grid.axes().steps()[2]).containsExactly(new double[] {0, 0, apart}, within(1e-9));
    }

    /** Planning scans of 3 mm in the target and 5 mm elsewhere. */
    @Test
    void planesOfTwoDistancesLieInSlicesOfTheirGreatestCommonOne() {
        assertSlices(grid(-10, -5, 0, 3, 6, 9, 14), 25, 1);
        assertSlices(grid(0, 2.5, 5, 9, 13), 27, 0.5);
        assertSlices(grid(0, 3, 6, 12, 15), 6, 3);
        assertThatThrownBy(() -> grid(0, 3, 6.71, 11.13, 14))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("unevenly apart");
    }

    @Test
    void contoursAtWholeMillimetresRunBetweenTheCentresOfVoxels() {
        assertThat(grid(0, 3).index(0, 0, 0, 0) % 1).isCloseTo(0.5, within(1e-9));
        assertThat(grid(0, 3).index(1, 0, 10, 0) % 1).isCloseTo(0.5, within(1e-9));
    }
}
