package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

class PieceJoinerTest {
    private static final int COLUMNS = 50;
    private static final int ROWS = 30;
    private static final int SLICES = 20;
    private static final int BONE = 1;
    private static final int LUNG = 2;

    private final byte[] labels = new byte[COLUMNS * ROWS * SLICES];
    private double spacingMm = 2;

    /** Fills a box: first column, row and slice, then the last ones. */
    private void box(int label, int... ends) {
        for (int k = ends[2]; k <= ends[5]; k++) {
            for (int j = ends[1]; j <= ends[4]; j++) {
                for (int i = ends[0]; i <= ends[3]; i++) {
                    labels[i + COLUMNS * (j + ROWS * k)] = (byte) label;
                }
            }
        }
    }

    /** Two pieces of a bone on one line, with so many empty columns between. */
    private void brokenBone(int gap) {
        box(BONE, 5, 12, 8, 20, 15, 11);
        box(BONE, 21 + gap, 12, 8, 31 + gap, 15, 11);
    }

    private Segmentation scan(String bone) {
        double mm = spacingMm;
        LabelGrid grid =
                LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {mm, 0, 0, 0, 0, mm, 0, 0, 0, 0, mm, 0});
        return new Segmentation(
                new LabelVolume(grid, Map.of(), List.of()), new LabelTable(Map.of(BONE, bone, LUNG, "lung_L")), "scan");
    }

    private static int pieces(Segmentation s, int segment) {
        VoxelRuns runs = VoxelRuns.ofSegments(s);
        int pieces = 0;
        for (int run = 0; run < runs.count(); run++) {
            pieces += runs.component(run) == run && s.segmentAt(runs.from(run)) == segment ? 1 : 0;
        }
        return pieces;
    }

    /** What of a bone is left of the two pieces, as a share of both. */
    private static double left(Segmentation s, int before) {
        return s.counts()[1] / (double) before;
    }

    /** Lung lies in the gap of a broken rib, on all lines between its pieces, but for a slit beside the rib. */
    @Test
    void aBridgeGoesRoundAnotherOrgan() {
        brokenBone(6);
        box(LUNG, 23, 0, 0, 24, ROWS - 1, SLICES - 1);
        box(0, 23, 10, 0, 24, 10, SLICES - 1);
        Segmentation s = scan("rib_06_L");
        int[] before = s.counts();
        assertThat(SegmentationRepair.mend(s))
                .anyMatch(note -> note.contains("joined") && note.contains("rib_06_L (2)"));
        assertThat(pieces(s, 1)).isEqualTo(1);
        assertThat(s.counts()[2]).as("voxels of the lung").isEqualTo(before[2]);
    }

    /** Through a wall of lung leads an opening from edge to edge of its voxels alone. */
    @Test
    void aPieceThatNoBridgeCanReachIsLeftOutWithANote() {
        brokenBone(6);
        box(LUNG, 23, 0, 0, 23, 13, SLICES - 1);
        box(LUNG, 24, 14, 0, 24, ROWS - 1, SLICES - 1);
        Segmentation s = scan("rib_06_L");
        assertThat(SegmentationRepair.mend(s))
                .noneMatch(note -> note.contains("joined"))
                .anyMatch(note -> note.startsWith("rib_06_L: what lies too far from its largest piece is left out"));
        assertThat(pieces(s, 1)).isEqualTo(1);
    }

    /** A gap lies between faces of voxels, whatever the spacing is rounded to. */
    @Test
    void piecesAreJoinedAcrossTheFullGap() {
        spacingMm = 2.00000001;
        brokenBone(5);
        Segmentation joined = scan("vertebra_T05");
        SegmentationRepair.mend(joined);
        assertThat(joined.counts()[1]).isGreaterThan(16 * 27);
        assertThat(pieces(joined, 1)).isEqualTo(1);

        brokenBone(6);
        box(0, 21, 12, 8, 26, 15, 11);
        Segmentation apart = scan("vertebra_T05");
        SegmentationRepair.mend(apart);
        assertThat(apart.counts()[1]).isEqualTo(16 * 16);
    }

    @Test
    void theHalvesOfASternumAreOneBone() {
        brokenBone(9);
        Segmentation s = scan("sternum");
        int before = s.counts()[1];
        SegmentationRepair.mend(s);
        assertThat(pieces(s, 1)).isEqualTo(1);
        assertThat(left(s, before)).isGreaterThan(1);
    }
}
