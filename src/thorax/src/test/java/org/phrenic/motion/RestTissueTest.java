package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;

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
}
