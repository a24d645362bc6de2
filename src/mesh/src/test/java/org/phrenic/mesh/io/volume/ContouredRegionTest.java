package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.io.raster.VolumeAxes;

/** Regions whose contours are circles, in voxels of 1 x 1 x 2 mm. */
class ContouredRegionTest {
    private static final int SIZE = 64;
    private static final SliceGrid GRID = new SliceGrid(
            SIZE, SIZE, 40, new VolumeAxes(new double[][] {{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}, new double[3]));

    private static List<double[]> circle(double x, double y, double radius) {
        double[] corners = new double[2 * 180];
        for (int c = 0; c < 180; c++) {
            corners[2 * c] = x + radius * Math.cos(Math.toRadians(2 * c));
            corners[2 * c + 1] = y + radius * Math.sin(Math.toRadians(2 * c));
        }
        return List.of(corners);
    }

    /** Number of voxels and sums of their columns and rows, by slice. */
    private static Map<Integer, double[]> slices(ContouredRegion region) {
        Map<Integer, double[]> slices = new TreeMap<>();
        region.forEach(voxel -> {
            double[] sums = slices.computeIfAbsent(voxel / (SIZE * SIZE), none -> new double[3]);
            sums[0]++;
            sums[1] += voxel % SIZE;
            sums[2] += voxel / SIZE % SIZE;
        });
        return slices;
    }

    private static ContouredRegion region(Map<Integer, List<double[]>> bySlice) {
        return ContouredRegion.of(GRID, new ContourFill(SIZE, SIZE), bySlice, false);
    }

    /** Radii of the contours kept of a slice, of circles at heights above it. */
    private static List<Double> kept(SlicePlane plane, double[]... heightAndRadius) {
        for (double[] one : heightAndRadius) {
            plane.add(one[0], circle(30, 30, one[1]).get(0));
        }
        return plane.contours().stream().map(corners -> corners[0] - 30).toList();
    }

    /** Nested outlines of three planes within a slice would leave a ring empty, equal ones would cancel. */
    @Test
    void ofASliceThePlaneNearestToItIsFilled() {
        SlicePlane three = new SlicePlane();
        assertThat(kept(three, new double[] {-0.2, 5}, new double[] {0, 8}, new double[] {0.2, 11}))
                .containsExactly(8.0);
        assertThat(three.size() - three.contours().size()).isEqualTo(2);
        assertThat(kept(new SlicePlane(), new double[] {0.125, 5}, new double[] {-0.125, 8}))
                .containsExactly(5.0);
        SlicePlane hole = new SlicePlane();
        assertThat(kept(hole, new double[] {0.1, 8}, new double[] {0.1 + 1e-9, 3}, new double[] {0.1, 8}))
                .as("a hole stays, what comes twice does not")
                .containsExactly(8.0, 3.0);
        assertThat(hole.size() - hole.contours().size()).isEqualTo(1);
        SlicePlane apart = new SlicePlane();
        apart.add(0, circle(15, 30, 5).get(0));
        apart.add(0.03, circle(45, 30, 6).get(0));
        apart.add(0.2, circle(45, 50, 4).get(0));
        apart.add(0.2, circle(45, 50, 2).get(0));
        assertThat(apart.contours())
                .as("two lungs of a plane by rounding, and what lies beside them, with its hole")
                .hasSize(4);
        assertThat(kept(new SlicePlane(), new double[] {-0.09, 5.1}, new double[] {0, 5}, new double[] {0.09, 4.9}))
                .as("planes a tenth of a slice apart")
                .containsExactly(5.0);
    }

    /** Of an oblique cone drawn in every fourth slice, radius and centre change linearly from slice to slice. */
    @Test
    void betweenContoursACrossSectionChangesLinearly() {
        Map<Integer, List<double[]>> drawn = new HashMap<>();
        for (int slice = 2; slice <= 14; slice += 4) {
            drawn.put(slice, circle(24 + 0.5 * slice, 30, 8 + slice));
        }
        ContouredRegion cone = region(drawn);
        Map<Integer, double[]> slices = slices(cone);
        assertThat(cone.slicesBetween()).isEqualTo(9);
        assertThat(slices.keySet()).containsExactly(2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14);
        slices.forEach((slice, sums) -> {
            assertThat(Math.sqrt(sums[0] / Math.PI)).isCloseTo(8 + slice, within(0.25));
            assertThat(sums[1] / sums[0]).isCloseTo(24 + 0.5 * slice, within(0.3));
            assertThat(sums[2] / sums[0]).isCloseTo(30, within(0.1));
        });
    }

    private static boolean isMask(double... corners) {
        return ContouredRegion.isMask(Stream.of(corners), false);
    }

    /** A damaged corner, as far away as numbers reach, is whole as well. */
    @Test
    void cornersOfAMaskLieAmongThePixelsOfAnImage() {
        assertThat(isMask(3, 4, 9, 4, 9, 10)).isTrue();
        assertThat(isMask(3, 4, 9, 4, 1e300, 10)).isFalse();
        assertThat(isMask(3, 4, 9, 4.5, 9, 10)).isFalse();
    }

    /** Pixels of 1 mm and contours in whole millimetres: drawn ones, and those along edges of pixels, stay as drawn. */
    @Test
    void outlinesOfAMaskStepFromPixelToPixel() {
        assertThat(isMask(0, 0, 10, 0, 10, 10, 0, 10)).as("a square").isFalse();
        assertThat(isMask(0, 0, 10, 0, 10, 5)).as("a slope of 27 degrees").isFalse();
        assertThat(isMask(0, 0, 9, 0, 9, 3, 3, 3, 3, 6, 6, 6, 6, 3, 9, 3, 9, 9, 0, 9))
                .as("a square with a cut to its hole, which goes on along the edges of both")
                .isFalse();
        double[] keyhole = {0, 0, 2, 3, 4, 3, 4, 6, 2, 6, 2, 3, 0, 0, 0, 9, 9, 9, 9, 0};
        assertThat(isMask(keyhole)).as("an oblique cut to a hole").isFalse();
        assertThat(isMask(3, 4, 7, 4)).as("a line").isTrue();
        assertThat(isMask(0, 1, 1, 0, 2, 0, 3, 1, 3, 2, 2, 3, 1, 3, 0, 2))
                .as("a disc")
                .isTrue();
        Map<Integer, List<double[]>> square = Map.of(0, List.of(new double[] {0, 0, 10, 0, 10, 10, 0, 10}));
        assertThat(slices(region(square)).get(0)[0]).isEqualTo(100);
    }

    /** Of an outline in each slice, an empty slice lies between two pieces. */
    @Test
    void piecesOfAMaskStayApart() {
        Map<Integer, List<double[]>> pieces = new HashMap<>();
        List<double[]> outline = List.of(new double[] {11, 10, 19, 10, 20, 11, 20, 20, 10, 20, 10, 11});
        for (int slice : new int[] {0, 1, 2, 4, 5, 6}) {
            pieces.put(slice, outline);
        }
        ContourFill fill = new ContourFill(SIZE, SIZE);
        assertThat(slices(ContouredRegion.of(GRID, fill, pieces, true)).keySet())
                .containsExactly(0, 1, 2, 4, 5, 6);
        assertThat(slices(ContouredRegion.of(GRID, fill, pieces, false)).keySet())
                .as("drawn in most slices")
                .containsExactly(0, 1, 2, 3, 4, 5, 6);
        Map<Integer, List<double[]>> second = Map.of(0, outline, 2, outline, 4, outline);
        assertThat(slices(ContouredRegion.of(GRID, fill, second, true)).keySet())
                .as("in every second slice")
                .containsExactly(0, 1, 2, 3, 4);
    }

    /** Slices of 2 mm: a gap of 16 mm, one of four times the usual gap, and pieces beside each other stay apart. */
    @Test
    void piecesOfARegionStayApart() {
        assertThat(slices(region(Map.of(0, circle(20, 20, 9), 8, circle(20, 20, 9))))
                        .keySet())
                .containsExactly(0, 8);
        Map<Integer, List<double[]>> apart = new HashMap<>();
        for (int slice : new int[] {0, 1, 2, 6, 7, 8}) {
            apart.put(slice, circle(20, 20, 9));
        }
        assertThat(slices(region(apart)).keySet()).containsExactly(0, 1, 2, 6, 7, 8);
        ContouredRegion beside = region(Map.of(0, circle(20, 20, 9), 3, circle(45, 20, 9)));
        assertThat(slices(beside).keySet()).containsExactly(0, 3);
        assertThat(beside.slicesBetween()).as("nothing is filled between them").isZero();
    }
}
