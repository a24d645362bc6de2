package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;

/** Volumes that end with their structures. */
class EmptySlicesTest {
    private static final double[] SLICES_OF_3_MM = {1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 3, 9};
    private static final int SIDE = 20;

    /** A ball of 20 slices under a label, of which the volume shows some. */
    private static LabelGrid ball(int label, int from, int to) {
        short[] labels = new short[SIDE * SIDE * (to - from)];
        for (int v = 0; v < labels.length; v++) {
            double x = v % SIDE - 9.5;
            double y = v / SIDE % SIDE - 9.5;
            double z = v / (SIDE * SIDE) + from - 9.5;
            labels[v] = (short) (x * x + y * y + z * z < 100 ? label : 0);
        }
        return LabelGrid.of(SIDE, SIDE, to - from, labels, SLICES_OF_3_MM);
    }

    @Test
    void aStructureThatTapersOffIsNotAtTheEnd() {
        for (int label : new int[] {1, 300}) {
            LabelGrid whole = ball(label, 0, SIDE);
            LabelGrid padded = EmptySlices.beyond(whole);
            assertThat(padded.slices()).isEqualTo(SIDE + 2);
            assertThat(padded.box(l -> l == label)).containsExactly(0, 0, 1, SIDE - 1, SIDE - 1, SIDE);
            double[] at = new double[3];
            padded.voxelToMm(0, 0, 1, at);
            assertThat(at).as("where the first slice was").containsExactly(7, 8, 9);
            assertThat(padded.counts()[label]).isEqualTo(whole.counts()[label]);
        }
    }

    @Test
    void aStructureThatIsCutThroughStaysAtTheEnd() {
        LabelGrid upper = EmptySlices.beyond(ball(1, 8, SIDE));
        assertThat(upper.slices()).isEqualTo(SIDE - 8 + 1);
        assertThat(upper.box(l -> l == 1)[2]).isZero();
    }

    /** Three slices, the first with some and the others with 100 voxels of a structure. */
    private static LabelGrid stub(int first) {
        byte[] labels = new byte[3 * SIDE * SIDE];
        for (int k = 0; k < 3; k++) {
            Arrays.fill(labels, k * SIDE * SIDE, k * SIDE * SIDE + (k == 0 ? first : 100), (byte) 1);
        }
        return LabelGrid.of(SIDE, SIDE, 3, labels, SLICES_OF_3_MM);
    }

    @Test
    void aStructureEndsWithUpToThreeTenthsOfItsGreatestCrossSection() {
        assertThat(EmptySlices.beyond(stub(30)).slices()).isEqualTo(4);
        assertThat(EmptySlices.beyond(stub(31)).slices()).isEqualTo(3);
    }

    @Test
    void aVolumeWithoutRoomForMoreSlicesIsNotExtended() {
        assertThat(EmptySlices.fits(1024, 1024, 2047)).isTrue();
        assertThat(EmptySlices.fits(1024, 1024, 2049)).isFalse();
        assertThat(EmptySlices.fits(1 << 16, 1 << 16, 2)).isFalse();
    }

    @Test
    void emptyEndsStayAsTheyAre() {
        LabelGrid padded = EmptySlices.beyond(ball(1, 0, SIDE));
        assertThat(EmptySlices.beyond(padded)).isSameAs(padded);
    }
}
