package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

class PieceJoinerTest {
    private static final int COLUMNS = 50;
    private static final int ROWS = 30;
    private static final int SLICES = 20;
    private static final int BONE = 1;
    private static final int LUNG = 2;
    private static final int REST = 3;

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
        return scan(bone, "skin");
    }

    private Segmentation scan(String bone, String rest) {
        double mm = spacingMm;
        LabelGrid grid =
                LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {mm, 0, 0, 0, 0, mm, 0, 0, 0, 0, mm, 0});
        return new Segmentation(
                new LabelVolume(grid, Map.of(), List.of()),
                new LabelTable(Map.of(BONE, bone, LUNG, "lung_L", REST, rest)),
                "scan");
    }

    private static int pieces(Segmentation s, int segment) {
        VoxelRuns runs = VoxelRuns.ofSegments(s);
        int pieces = 0;
        for (int run = 0; run < runs.count(); run++) {
            pieces += runs.component(run) == run && s.segmentAt(runs.from(run)) == segment ? 1 : 0;
        }
        return pieces;
    }

    /**
     * The third piece is out of reach of the first, and a fourth of both; the two lie on in the order of their sizes.
     */
    @Test
    void piecesAreJoinedInAChainAndWhatLiesFarOffIsNot() {
        box(BONE, 2, 2, 2, 9, 5, 5);
        box(BONE, 28, 2, 2, 33, 5, 5);
        box(BONE, 18, 2, 2, 19, 5, 5);
        box(BONE, 46, 26, 16, 48, 28, 18);
        Segmentation s = scan("rib_06_L");
        assertThat(SegmentationRepair.mend(s))
                .anyMatch(note -> note.contains("joined") && note.contains("rib_06_L (3)"))
                .anyMatch(note -> note.startsWith("rib_06_L: what lies too far"));
        assertThat(pieces(s, 1)).isEqualTo(1);
    }

    /** A pit of a voxel in each of two parts of a bone, one above the other with so many empty slices between. */
    @ParameterizedTest
    @CsvSource({"1, 36", "2, 72", "3, 0", "4, 0", "9, 0"})
    void aBoneIsClosedOverTwoSlicesAndItsPartsByThemselves(int apart, int between) {
        box(BONE, 5, 5, 2, 10, 10, 4);
        box(0, 7, 7, 3, 7, 7, 3);
        box(BONE, 5, 5, 5 + apart, 10, 10, 7 + apart);
        box(0, 7, 7, 6 + apart, 7, 7, 6 + apart);
        boolean[] free = {true, false};
        assertThat(BoneClosing.close(scan("hip_L"), List.of(1), free)).isEqualTo(2 + between);
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

    /** A part of a vertebra that no bridge reaches, in the middle of a muscle: that has no hole there. */
    @Test
    void aPieceThatIsLeftOutWithinAMuscleBecomesMuscle() {
        box(REST, 2, 2, 2, COLUMNS - 3, ROWS - 3, SLICES - 3);
        brokenBone(8);
        Segmentation s = scan("vertebra_T05", "autochthon_L");
        int[] before = s.counts();
        assertThat(SegmentationRepair.mend(s))
                .anyMatch(
                        note -> note.startsWith("vertebra_T05: what lies too far from its largest piece is left out"));
        assertThat(pieces(s, 1)).isEqualTo(1);
        assertThat(s.counts()[0]).as("background").isEqualTo(before[0]);
    }

    /** 10 mm from voxel to voxel, but for the rounding of the spacing. */
    @Test
    void aRoundedSpacingDoesNotShortenTheReach() {
        spacingMm = 2.00000001;
        brokenBone(4);
        Segmentation s = scan("vertebra_T05");
        SegmentationRepair.mend(s);
        assertThat(pieces(s, 1)).isEqualTo(1);
        assertThat(s.counts()[1]).isGreaterThan(27 * 16);
    }

    @Test
    void theHalvesOfASternumAreOneBone() {
        brokenBone(8);
        Segmentation s = scan("sternum");
        int before = s.counts()[1];
        SegmentationRepair.mend(s);
        assertThat(pieces(s, 1)).isEqualTo(1);
        assertThat(s.counts()[1]).isGreaterThan(before);
    }

    /**
     * A label takes all that is no bone, pits and the gap of a break too: where it only fills the space between organs
     * the bone is mended as in background.
     */
    @ParameterizedTest
    @CsvSource({
        "skin, true",
        "muscle_skeletal, true",
        "autochthon_L, true",
        "other_pericardial_fat, true",
        "other_trunk_muscles, true",
        "other_subcutaneous_tissue, true",
        "other_abdominal_cavity, true",
        "spleen, false",
        "other_soft_tissue_mass, false",
        "other_soft_tissue_tumour_2, false",
        "other_tissue_expander, false",
        "other_pleural_cavity, false",
        "other_breast_tissue, false",
        "other_lung_tissue, false",
        "other_breast_implant_left, false",
        "lesion_fatty, false",
        "other_fatal_label, false"
    })
    void bonesAreMendedThroughWhatFillsTheSpaceBetweenOrgans(String rest, boolean fills) {
        brokenBone(6);
        box(0, 10, 13, 8, 10, 14, 8);
        // The volume is not cropped to the bone.
        box(LUNG, 0, 0, 0, 2, 2, 2);
        box(LUNG, COLUMNS - 3, ROWS - 3, SLICES - 3, COLUMNS - 1, ROWS - 1, SLICES - 1);
        Segmentation inBackground = scan("rib_06_L", rest);
        SegmentationRepair.mend(inBackground);
        for (int v = 0; v < labels.length; v++) {
            labels[v] = labels[v] == 0 ? REST : labels[v];
        }
        Segmentation s = scan("rib_06_L", rest);
        int before = s.counts()[1];
        SegmentationRepair.mend(s);
        assertThat(s.counts()[1] == inBackground.counts()[1]).as(rest).isEqualTo(fills);
        assertThat(s.counts()[1] > before).as("grown").isEqualTo(fills);
    }
}
