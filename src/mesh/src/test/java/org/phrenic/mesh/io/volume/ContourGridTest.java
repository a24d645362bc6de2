package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
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

    /** Outlines of squares without corners, through centres of pixels of 0.8 mm from (-250.3, -241.7) on. */
    private static List<double[]> outlines(int count) {
        List<double[]> outlines = new ArrayList<>();
        for (int n = 0; n < count; n++) {
            int side = 6 + n % 7;
            int[] corners = {1, 0, side - 1, 0, side, 1, side, side - 1, side - 1, side, 1, side, 0, side - 1, 0, 1};
            double[] points = new double[corners.length / 2 * 3];
            for (int c = 0; c < corners.length / 2; c++) {
                points[3 * c] = -250.3 + 0.8 * (13 * n + corners[2 * c]);
                points[3 * c + 1] = -241.7 + 0.8 * (7 * n + corners[2 * c + 1]);
                points[3 * c + 2] = 3 * n;
            }
            outlines.add(points);
        }
        return outlines;
    }

    /** A drawn outline, one of a mask with an oblique cut to a hole and lines of one pixel among 40 of masks. */
    @Test
    void pixelsOfMasksAreFoundBesideAFewOtherContours() {
        List<double[]> contours = outlines(40);
        double[] drawn = {-260.11, -250.03, 0, -20.4, -245.37, 0, -31.7, -15.23, 0, -250.05, -16.6, 0, -250.18, -17, 0};
        contours.add(drawn);
        double[] first = contours.get(0);
        double[] hole = new double[first.length + 12];
        System.arraycopy(first, 0, hole, 0, first.length);
        int[] cut = {1, 0, 2, 3, 3, 2, 2, 3};
        for (int c = 0; c < 4; c++) {
            hole[first.length + 3 * c] = -250.3 + 0.8 * cut[2 * c];
            hole[first.length + 3 * c + 1] = -241.7 + 0.8 * cut[2 * c + 1];
        }
        contours.set(0, hole);
        ContourGrid own = new ContourGrid("contours", List.of(contours));
        SliceGrid grid = own.grid();
        assertThat(own.isThroughCentres()).isTrue();
        assertThat(grid.axes().steps()[0][0]).isCloseTo(0.8, within(1e-6));
        assertThat(grid.axes().steps()[1][1]).isCloseTo(0.8, within(1e-6));
        double[] index = {grid.index(0, -250.3, -241.7, 0), grid.index(1, -250.3, -241.7, 0)};
        assertThat(index).containsExactly(new double[] {Math.rint(index[0]), Math.rint(index[1])}, within(1e-4));
        assertThat(grid.index(0, -260.11, 0, 0)).isPositive();
        contours.addAll(List.of(drawn, drawn));
        ContourGrid mixed = new ContourGrid("contours", List.of(contours));
        assertThat(mixed.grid().axes().steps()[0][0])
                .as("three drawn ones of 43")
                .isEqualTo(1);
        assertThat(mixed.isThroughCentres()).isFalse();
    }

    /** Pixels of 1 mm with a whole origin: their edges are at half millimetres. */
    @Test
    void outlinesAlongEdgesOfPixelsRunBetweenTheCentresOfVoxels() {
        List<double[]> steps = new ArrayList<>();
        for (int n = 0; n < 5; n++) {
            double x = n - 250.5;
            double y = n + 0.5;
            steps.add(new double[] {x, y, n, x + 3, y, n, x + 3, y + 4, n, x + 2, y + 4, n, x + 2, y + 5, n, x, y + 5, n
            });
        }
        ContourGrid own = new ContourGrid("contours", List.of(steps));
        assertThat(own.grid().index(0, -250.5, 0.5, 0) % 1).isCloseTo(0.5, within(1e-6));
        assertThat(own.isThroughCentres()).isFalse();
    }

    /** A mask of one pixel's width has no area and no diagonal. */
    @Test
    void linesOfPixelsRunThroughTheirCentres() {
        List<double[]> lines = new ArrayList<>();
        for (int n = 0; n < 8; n++) {
            lines.add(new double[] {0.8 * n, 0, n, 0.8 * n, 4, n});
            double y = 0.8 * n;
            lines.add(new double[] {0, y, n, 0.8 * n, y, n, 0.8 * n, y + 0.8, n, 0.8 * n, y, n});
        }
        lines.add(new double[] {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0});
        ContourGrid own = new ContourGrid("contours", List.of(lines));
        own.grid();
        assertThat(own.isThroughCentres()).isTrue();
    }
}
