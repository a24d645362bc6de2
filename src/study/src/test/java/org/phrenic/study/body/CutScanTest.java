package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.voxel.LabelGrid;

class CutScanTest {
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
    private static final int LIVER = 5;
    private static final int RIGHT_LUNG = 12;
    private static final int LEFT_LUNG = 10;
    private static final int LEFT_RIB_7 = 98;
    private static final LabelGrid WHOLE = CutScan.of(MAN, BodyCut.WHOLE);

    private static int count(LabelGrid grid, int label) {
        int[] counts = grid.counts();
        return label < counts.length ? counts[label] : 0;
    }

    @Test
    void wholeScanHasTheVolumesOfTheBody() {
        double liver = MeshMeasure.signedVolume(MAN.find("liver").orElseThrow().mesh());
        assertThat(count(WHOLE, LIVER) * WHOLE.voxelVolume() / liver).isCloseTo(1, within(0.01));
        // The same body in an oblique grid: the same volumes.
        LabelGrid oblique = CutScan.of(MAN, BodyCut.OBLIQUE);
        assertThat((double) count(oblique, LEFT_RIB_7) / count(WHOLE, LEFT_RIB_7))
                .isCloseTo(1, within(0.03));
    }

    /** An import builds the diaphragm between them. */
    @Test
    void aScanOfAVirtualBodyShowsItsFurtherOrgans() {
        int compared = 0;
        for (Structure organ : MAN.organs().get()) {
            int label =
                    switch (organ.name()) {
                        case "spleen" -> 1;
                        case "kidney_R" -> 2;
                        case "kidney_L" -> 3;
                        case "stomach" -> 6;
                        default -> 0;
                    };
            if (label > 0) {
                compared++;
                double volume = MeshMeasure.signedVolume(organ.mesh());
                assertThat(count(WHOLE, label) * WHOLE.voxelVolume() / volume)
                        .as(organ.name())
                        .isCloseTo(1, within(0.03));
            }
        }
        assertThat(compared).isEqualTo(4);
        assertThat(count(CutScan.of(MAN, BodyCut.COMMON_LABELS), 4)).isPositive();
    }

    /** What a rebuilt body is held against lies where the scan shows it. */
    @Test
    void aTurnedScanShowsTheTurnedBody() {
        double[] liver = MeshMeasure.centreOfMass(
                CutScan.inScan(MAN, BodyCut.TURNED).find("liver").orElseThrow().mesh());
        LabelGrid turned = CutScan.of(MAN, BodyCut.TURNED);
        double[] sum = new double[3];
        double[] p = new double[3];
        int voxels = count(turned, LIVER);
        int voxel = 0;
        for (int k = 0; k < turned.slices(); k++) {
            for (int j = 0; j < turned.rows(); j++) {
                for (int i = 0; i < turned.columns(); i++) {
                    if (turned.label(voxel++) == LIVER) {
                        turned.voxelToMm(i, j, k, p);
                        for (int axis = 0; axis < 3; axis++) {
                            sum[axis] += p[axis] / voxels;
                        }
                    }
                }
            }
        }
        assertThat(sum).containsExactly(liver, within(0.5));
        assertThat(CutScan.inScan(MAN, BodyCut.OBLIQUE)).isSameAs(MAN);
    }

    @Test
    void aFieldOfViewThatHoldsNothingIsRefused() {
        Thorax skinAlone = new Thorax("skin alone", MAN.structuresOf(StructureKind.SKIN), List.of());
        assertThatThrownBy(() -> CutScan.of(skinAlone, BodyCut.WHOLE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("skin alone: found a field of view");
    }

    @Test
    void commonLabelsHoldBothLungsAndAllBones() {
        LabelGrid common = CutScan.of(MAN, BodyCut.COMMON_LABELS);
        assertThat(count(common, 3)).isEqualTo(count(WHOLE, LEFT_LUNG) + count(WHOLE, RIGHT_LUNG));
        int[] counts = WHOLE.counts();
        // Vertebrae from L5 to T1, ribs and sternum; cartilages are no bones.
        int bones = IntStream.rangeClosed(27, 43).map(label -> counts[label]).sum()
                + IntStream.rangeClosed(92, 116).map(label -> counts[label]).sum();
        assertThat((double) count(common, 5) / bones).isCloseTo(1, within(0.01));
    }

    @Test
    void cutsShowWhatTheySay() {
        LabelGrid bones = CutScan.of(MAN, BodyCut.BONES);
        assertThat(count(bones, LIVER) + count(bones, RIGHT_LUNG)).isZero();
        assertThat(count(bones, LEFT_RIB_7)).isPositive();
        LabelGrid right = CutScan.of(MAN, BodyCut.RIGHT_SIDE);
        assertThat(count(right, RIGHT_LUNG)).isGreaterThan(count(WHOLE, RIGHT_LUNG) * 9 / 10);
        assertThat(count(right, LEFT_LUNG) + count(right, LEFT_RIB_7)).isLessThan(count(WHOLE, LEFT_RIB_7));
        LabelGrid abdomen = CutScan.of(MAN, BodyCut.ABDOMEN);
        assertThat(count(abdomen, LIVER)).isEqualTo(count(WHOLE, LIVER));
        assertThat((double) count(abdomen, RIGHT_LUNG) / count(WHOLE, RIGHT_LUNG))
                .isBetween(0.1, 0.5);
    }

    /** 20 mm of a rib of 309 mm, whose neck is thinner than its shaft. */
    @Test
    void ribsAreShortenedAndBonesAreDamaged() {
        LabelGrid cut = CutScan.of(MAN, BodyCut.RIBS_20);
        assertThat((double) count(cut, LEFT_RIB_7) / count(WHOLE, LEFT_RIB_7)).isBetween(0.92, 0.97);
        LabelGrid dropped = CutScan.of(MAN, BodyCut.DROPPED);
        assertThat((double) count(dropped, LEFT_RIB_7) / count(WHOLE, LEFT_RIB_7))
                .isCloseTo(0.95, within(0.02));
        assertThat(count(dropped, LIVER)).isEqualTo(count(WHOLE, LIVER));
    }

    /** The lower half of a lung is broader than its upper half. */
    @Test
    void fluidTakesTheLowerHalfOfTheRightLung() {
        LabelGrid cut = CutScan.of(MAN, BodyCut.EFFUSION);
        assertThat((double) count(cut, RIGHT_LUNG) / count(WHOLE, RIGHT_LUNG)).isBetween(0.35, 0.5);
        assertThat(count(cut, LEFT_LUNG)).isEqualTo(count(WHOLE, LEFT_LUNG));
        int[] whole = WHOLE.box(label -> label == RIGHT_LUNG);
        int[] above = cut.box(label -> label == RIGHT_LUNG);
        assertThat(above[2] - whole[2]).isCloseTo((whole[5] - whole[2]) / 2, within(1));
        assertThat(above[5]).isEqualTo(whole[5]);
    }
}
