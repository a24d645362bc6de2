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
        return outline(shell(gap), Map.of(1, "skin"), 1);
    }

    /** @param gap number of slices in which the shell is open on one side */
    private static byte[] shell(int gap) {
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
        return labels;
    }

    private static LabelGrid outline(byte[] labels, Map<Integer, String> structures, int times) {
        return outline(
                LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0}),
                structures,
                times);
    }

    private static LabelGrid outline(LabelGrid grid, Map<Integer, String> structures, int times) {
        LabelVolume volume = new LabelVolume(grid, Map.of(), List.of());
        Segmentation body = new Segmentation(volume, new LabelTable(structures), "scan");
        return FilledOutline.of(body, new int[] {times, times, times});
    }

    @Test
    void aShellIsFilledThoughTheScanCutsItAboveAndBelow() {
        assertThat(outline(0).counts()[1]).isEqualTo(16 * 12 * SLICES);
    }

    /** The same voxels in coronal and in sagittal slices, whose rows and columns run up. */
    @Test
    void aShellIsFilledWhicheverWayTheSlicesLie() {
        byte[] axial = shell(0);
        byte[] coronal = new byte[axial.length];
        byte[] sagittal = new byte[axial.length];
        for (int v = 0; v < axial.length; v++) {
            int i = v % COLUMNS;
            int j = v / COLUMNS % ROWS;
            int k = v / COLUMNS / ROWS;
            coronal[i + COLUMNS * (k + SLICES * j)] = axial[v];
            sagittal[k + SLICES * (j + ROWS * i)] = axial[v];
        }
        for (LabelGrid grid : List.of(
                LabelGrid.of(COLUMNS, SLICES, ROWS, coronal, new double[] {3, 0, 0, 0, 0, 0, 3, 0, 0, 3, 0, 0}),
                LabelGrid.of(SLICES, ROWS, COLUMNS, sagittal, new double[] {0, 0, 3, 0, 0, 3, 0, 0, 3, 0, 0, 0}))) {
            assertThat(outline(grid, Map.of(1, "skin"), 1).counts()[1]).isEqualTo(16 * 12 * SLICES);
        }
    }

    @Test
    void aLayerWhoseShellIsOpenStaysAsItIs() {
        assertThat(outline(1).counts()[1]).isEqualTo(16 * 12 * (SLICES - 1) + 2 * 16 + 2 * 10 - 1);
    }

    /** Of two neighbouring voxels that become one, the shell may be in either: its middle lies in one of them. */
    @Test
    void aShellIsFilledInLargerVoxelsAsWell() {
        LabelGrid outline = outline(shell(0), Map.of(1, "skin"), 2);
        assertThat(outline.counts()[1]).isEqualTo(8 * 6 * SLICES / 2);
        assertThat(outline.columns()).isEqualTo(8);
    }

    /** The skin begins in the third column, row and in the first slice. */
    @Test
    void aLargerVoxelLiesWhereItIsSampled() {
        double[] at = new double[3];
        for (int times = 1; times < 4; times++) {
            outline(shell(0), Map.of(1, "skin"), times).voxelToMm(0, 0, 0, at);
            int middle = times / 2;
            assertThat(at).containsExactly(3 * (2 + middle), 3 * (2 + middle), 3 * middle);
        }
    }

    /** A couch below the back, a target volume that reaches beyond the skin, and an unknown structure in the body. */
    @Test
    void aCouchAndATargetVolumeBeyondTheSkinAreNoPartOfTheBody() {
        byte[] labels = shell(0);
        for (int k = 0; k < SLICES; k++) {
            for (int i = 4; i < 16; i++) {
                labels[i + COLUMNS * (14 + ROWS * k)] = 2;
            }
            for (int i = 0; i < 6; i++) {
                int v = i + COLUMNS * (7 + ROWS * k);
                labels[v] = labels[v] == 1 ? labels[v] : 3;
            }
            labels[9 + COLUMNS * (9 + ROWS * k)] = 4;
        }
        Map<Integer, String> structures = Map.of(1, "skin", 2, "other_couch", 3, "lesion_ptv", 4, "other_4");
        assertThat(outline(labels, structures, 1).counts()[1]).isEqualTo(16 * 12 * SLICES);
    }
}
