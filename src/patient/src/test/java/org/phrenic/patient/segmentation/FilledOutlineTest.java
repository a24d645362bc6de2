package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/**
 * A trunk of 16 x 12 voxels in 10 axial slices, whose skin is labelled as a shell of one voxel that ends with the scan.
 */
class FilledOutlineTest {
    private static final int COLUMNS = 20;
    private static final int ROWS = 16;
    private static final int SLICES = 10;

    private static LabelGrid outline(int gap) {
        byte[] labels = new byte[COLUMNS * ROWS * SLICES];
        for (int k = 0; k < SLICES; k++) {
            for (int j = 2; j < 14; j++) {
                for (int i = 2; i < 18; i++) {
                    boolean shell = i == 2 || i == 17 || j == 2 || j == 13;
                    boolean open = k < gap && i == 2 && j == 7;
                    labels[i + COLUMNS * (j + ROWS * k)] = (byte) (shell && !open ? 1 : 0);
                }
            }
        }
        LabelGrid grid = LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0});
        LabelVolume volume = new LabelVolume(grid, Map.of(), List.of());
        Segmentation body = new Segmentation(volume, new LabelTable(Map.of(1, "skin")), "scan");
        return FilledOutline.of(body, new int[] {1, 1, 1});
    }

    @Test
    void aShellIsFilledThoughTheScanCutsItAboveAndBelow() {
        assertThat(outline(0).counts()[1]).isEqualTo(16 * 12 * SLICES);
    }

    @Test
    void aLayerWhoseShellIsOpenStaysAsItIs() {
        assertThat(outline(1).counts()[1]).isEqualTo(16 * 12 * (SLICES - 1) + 2 * 16 + 2 * 10 - 1);
    }
}
