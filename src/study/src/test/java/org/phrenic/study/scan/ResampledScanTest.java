package org.phrenic.study.scan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

class ResampledScanTest {
    /** 20 x 30 x 40 voxels of 2 x 1 x 0.5 mm whose label is 3 in the half with the higher rows. */
    private static LabelGrid halves() {
        byte[] labels = new byte[20 * 30 * 40];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) (v / 20 % 30 >= 15 ? 3 : 0);
        }
        return LabelGrid.of(20, 30, 40, labels, new double[] {2, 0, 0, 5, 0, 1, 0, 6, 0, 0, 0.5, 7});
    }

    @Test
    void theBoxAndTheVolumeOfALabelStay() {
        LabelGrid fine = ResampledScan.of(halves(), new ScanSize(50, 44, 60));
        assertThat(fine.counts()[3] * fine.voxelVolume())
                .isCloseTo(halves().counts()[3] * halves().voxelVolume(), within(1e-6));
        double[] low = new double[3];
        double[] high = new double[3];
        fine.voxelToMm(-0.5, -0.5, -0.5, low);
        fine.voxelToMm(49.5, 43.5, 59.5, high);
        assertThat(low).containsExactly(new double[] {4, 5.5, 6.75}, within(1e-9));
        assertThat(high).containsExactly(new double[] {44, 35.5, 26.75}, within(1e-9));
    }

    @Test
    void aSizeThatIsNoneIsRefused() {
        assertThat(ScanSize.parse("512x512x600")).isEqualTo(new ScanSize(512, 512, 600));
        for (String bad : new String[] {"512x512", "8x512x512", "9999x9999x9999", "a"}) {
            assertThatThrownBy(() -> ScanSize.parse(bad))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining(bad);
        }
    }
}
