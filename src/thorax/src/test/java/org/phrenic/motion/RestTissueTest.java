package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.VoxelBox;

/** A line of ten voxels of 2 mm, four of region 1, six of region 2; each holds its number as value. */
class RestTissueTest {
    private static final float BEYOND = -1000;
    private static final float[] VALUES = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};

    private final RestTissue tissue = new RestTissue(
            new VoxelBox(new int[] {10, 1, 1}, new double[] {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}),
            new byte[] {1, 1, 1, 1, 2, 2, 2, 2, 2, 2});

    @Test
    void readsItsOwnRegionWhereItIs() {
        assertThat(tissue.label(VALUES, 1, 2.4, 0, 0)).isEqualTo(2);
        assertThat(tissue.value(VALUES, 1, 2.4, 0, 0, BEYOND)).isEqualTo(2.4f);
        assertThat(tissue.value(VALUES, 2, 8.75, 0, 0, BEYOND)).isEqualTo(8.75f);
    }

    @Test
    void takesTheNearestVoxelOfItsRegionAcrossABorder() {
        assertThat(tissue.label(VALUES, 2, 1.2, 0.3, 0)).isEqualTo(4);
        assertThat(tissue.label(VALUES, 1, 8.9, 0, 0)).isEqualTo(3);
        assertThat(tissue.value(VALUES, 1, 3.6, 0, 0, BEYOND)).isEqualTo(3);
    }

    @Test
    void mixesNoTissueOfAnotherRegionIn() {
        assertThat(tissue.value(VALUES, 1, 3.4, 0, 0, BEYOND)).isEqualTo(3);
        assertThat(tissue.value(VALUES, 2, 3.6, 0, 0, BEYOND)).isEqualTo(4);
    }

    @Test
    void readsThePlaceWhereTheRegionIsOutOfReach() {
        assertThat(tissue.label(VALUES, 3, 6.2, 0, 0)).isEqualTo(6);
        assertThat(tissue.value(VALUES, 3, 6.5, 0, 0, BEYOND)).isEqualTo(6.5f);
    }

    @Test
    void readsNothingBeyondTheImage() {
        assertThat(tissue.label(VALUES, 2, 9.6, 0, 0)).isZero();
        assertThat(tissue.value(VALUES, 2, 5, 0.6, 0, BEYOND)).isEqualTo(BEYOND);
        assertThat(tissue.value(VALUES, 2, Double.NaN, 0, 0, BEYOND)).isEqualTo(BEYOND);
    }

    /** Voxels of 1 by 2 by 5 mm, four in each direction, all of region 1 but those given; voxel i, j, k holds kji. */
    private static RestTissue box(int... ofRegionTwo) {
        byte[] regions = new byte[64];
        Arrays.fill(regions, (byte) 1);
        for (int number : ofRegionTwo) {
            regions[number % 10 + 4 * (number / 10 % 10) + 16 * (number / 100)] = 2;
        }
        return new RestTissue(
                new VoxelBox(new int[] {4, 4, 4}, new double[] {1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 5, 0}), regions);
    }

    private static float[] numbers() {
        float[] values = new float[64];
        for (int v = 0; v < values.length; v++) {
            values[v] = v % 4 + 10 * (v / 4 % 4) + 100 * (v / 16);
        }
        return values;
    }

    @Test
    void isLinearInEveryDirection() {
        assertThat(box().value(numbers(), 1, 1.25, 2.4, 0.7, BEYOND)).isCloseTo(1.25f + 24 + 70, within(1e-4f));
        assertThat(box().value(numbers(), 1, 2.9, 0.1, 1.2, BEYOND)).isCloseTo(2.9f + 1 + 120, within(1e-4f));
        assertThat(box().value(numbers(), 1, -0.3, 3.4, 3.1, BEYOND))
                .as("the outermost voxels go on to their faces")
                .isCloseTo(0 + 30 + 300, within(1e-4f));
    }

    @Test
    void nearestIsMeasuredInMillimetresAndNotInVoxels() {
        // From voxel 111 to 113 are 2 mm, to 121 too, to 131 are 4 mm, to 211 are 5 mm.
        assertThat(box(211, 113).label(numbers(), 2, 1, 1, 1)).isEqualTo(113);
        assertThat(box(211, 131).label(numbers(), 2, 1, 1, 1)).isEqualTo(131);
        assertThat(box(121, 113).label(numbers(), 2, 1.4, 1, 1)).isEqualTo(113);
        assertThat(box(121, 113).label(numbers(), 2, 0.6, 1, 1)).isEqualTo(121);
        assertThat(box(121, 101).label(numbers(), 2, 1, 1.2, 1)).isEqualTo(121);
        assertThat(box(211, 11).label(numbers(), 2, 1, 1, 1.2)).isEqualTo(211);
        assertThat(box(211, 11).label(numbers(), 2, 1, 1, 0.8)).isEqualTo(11);
    }

    @Test
    void aVoxelStraightBesideIsFoundInEveryDirection() {
        for (int number : new int[] {11, 211, 101, 121, 110, 112, 311, 131, 113}) {
            assertThat(box(number).label(numbers(), 2, 1, 1, 1)).isEqualTo(number);
            assertThat(box(number).value(numbers(), 2, 1, 1, 1, BEYOND)).isEqualTo(number);
        }
    }
}
