package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/** Parts under the label of a rib that are none of it, and last ribs that lie beside each other. */
class RibNumberingTest {
    private static final int SLICE = CageVoxels.COLUMNS * CageVoxels.ROWS;

    /** The slices of a cage from one on, with labels of each rib. */
    private static Segmentation from(CageVoxels cage, int slice) {
        byte[] labels = Arrays.copyOfRange(cage.labels, slice * SLICE, cage.labels.length);
        return new Segmentation(CageVoxels.volume(labels), CageVoxels.table(false), "scan");
    }

    /** Adds an arc to the right of the spine that begins at a slice, over a share of half a turn. */
    private static void arc(CageVoxels cage, double slice, double share, int label) {
        for (int step = 0; step <= 400 * share; step++) {
            double angle = Math.PI * step / 400;
            double x = 44.5 - 36 * StrictMath.sin(angle) - 6;
            cage.ball(x, 30 + 22 * StrictMath.cos(angle), slice - 12 * angle / Math.PI, 1.6, label);
        }
    }

    private static void clear(CageVoxels cage, int label) {
        for (int v = 0; v < cage.labels.length; v++) {
            cage.labels[v] = (cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == label ? 0 : cage.labels[v];
        }
    }

    /** Gives the front of right rib 2 the label of rib 3, which then holds parts of two ribs. */
    private static void labelFrontOfSecondAsThird(CageVoxels cage) {
        for (int v = 0; v < cage.labels.length; v++) {
            boolean front = v / CageVoxels.COLUMNS % CageVoxels.ROWS < 30;
            boolean second = (cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.rib(2, true);
            cage.labels[v] = second && front ? (byte) CageVoxels.rib(3, true) : cage.labels[v];
        }
    }

    /** The scan ends below the heads of the tenth ribs. */
    @Test
    void aCervicalRibUnderTheLabelOfTheFirstIsLeftOut() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 40));
        assertThat(truth).hasSize(20);
        arc(cage, 124, 0.3, CageVoxels.rib(1, true));
        Segmentation s = from(cage, 40);
        assertThat(BoneNumbering.numberRibs(s))
                .containsExactly("label 104 holds parts of two ribs: the 20 connected ribs are numbered from top to"
                        + " bottom by their vertebrae; left out, away from the rib of their label: a part of label 104 at"
                        + " the height of C7 on the right");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** From the third on right ribs carry the number of the one above, so that two share the label of the second. */
    @Test
    void aRibUnderTheLabelOfItsNeighbourIsKept() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 40));
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean slipped = label >= CageVoxels.rib(3, true) && label <= CageVoxels.rib(12, true);
            cage.labels[v] = slipped ? (byte) (label - 1) : cage.labels[v];
        }
        Segmentation s = from(cage, 40);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().endsWith("by their vertebrae");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** Left ribs 5, 6 and 7 touch at their sides, as where a small spine is bent, and right rib 2 has two labels. */
    @Test
    void ribsThatTouchAreToldApartByTheirLabels() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        for (int number = 5; number < 7; number++) {
            for (int step = 0; step <= 8; step++) {
                cage.ball(86.5, 30, 118 - 8 * number - step, 1, CageVoxels.rib(step < 4 ? number : number + 1, false));
            }
        }
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 0));
        labelFrontOfSecondAsThird(cage);
        Segmentation s = from(cage, 0);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().contains("holds parts of two ribs");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** All ribs of the left side touch at the side or at the back, and rib 5 that of the other side. */
    @Test
    void aWholeCageInOnePartIsToldApartByItsLabels() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        for (int number = 1; number < 12; number++) {
            for (int step = 0; step <= 8; step++) {
                int label = CageVoxels.rib(step < 4 ? number : number + 1, false);
                cage.ball(
                        number < 10 ? 86.5 : 52,
                        number < 10 ? 30 : 52,
                        118 - 8 * number + (number < 10 ? 0 : 6) - step,
                        1,
                        label);
            }
        }
        for (int step = 0; step <= 16; step++) {
            cage.ball(36.5 + step, 53.5, 83, 1.5, CageVoxels.rib(5, step < 8));
        }
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 0));
        labelFrontOfSecondAsThird(cage);
        Segmentation s = from(cage, 0);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().contains("24 connected ribs");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** The front of right rib 6 carries the label of rib 7, and ribs 7 to 11 those of 8 to 12; there is no rib 12. */
    @Test
    void aRibOfTwoLabelsThatNoOtherHasIsOneRib() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        clear(cage, CageVoxels.rib(12, true));
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 0));
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean front = v / CageVoxels.COLUMNS % CageVoxels.ROWS < 30;
            boolean other = label > CageVoxels.rib(6, true) || (label == CageVoxels.rib(6, true) && front);
            cage.labels[v] = (byte) (other ? label + 1 : label);
        }
        Segmentation s = from(cage, 0);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().contains("leave out a number");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** Right ribs from the second on and the spine carry the number of the one above. Nothing is cut off. */
    @Test
    void aCompleteCageKeepsItsTwelveRibsBesideASlippedSpine() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 0));
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            if (label > CageVoxels.rib(1, true) && label <= CageVoxels.rib(12, true)) {
                cage.labels[v] = (byte) (label - 1);
            } else if (label >= CageVoxels.vertebra(12) && label <= CageVoxels.vertebra(1)) {
                cage.labels[v] = (byte) (label == CageVoxels.vertebra(1) ? 0 : label + 1);
            }
        }
        Segmentation s = from(cage, 0);
        assertThat(BoneNumbering.numberRibs(s)).last().asString().contains("vertebra_T12 is vertebra_L01");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** It is longer than the twelfth, whose label it carries. */
    @Test
    void aThirteenthRibIsLeftOutByItsVertebra() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 0));
        arc(cage, 124 - 8 * 13, 0.35, CageVoxels.rib(12, true));
        Segmentation s = from(cage, 0);
        assertThat(CageVoxels.ribCounts(s).get("rib_12_R")).isGreaterThan(2 * truth.get("rib_12_R"));
        assertThat(BoneNumbering.numberRibs(s))
                .singleElement()
                .asString()
                .endsWith(": a part of label 115 at the height of L1 on the right");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** Twelfth ribs of a thirtieth of the usual one. */
    private static CageVoxels withShortTwelfthRibs() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        for (boolean right : new boolean[] {true, false}) {
            clear(cage, CageVoxels.rib(12, right));
            for (int n = 0; n < 24; n++) {
                cage.ball(44.5 + (right ? -1 : 1) * (6.5 + n), 52, 26 - n / 6, 0.5, CageVoxels.rib(12, right));
            }
        }
        return cage;
    }

    @Test
    void aShortTwelfthRibIsNoFragmentOfTheEleventh() {
        for (boolean spine : new boolean[] {true, false}) {
            CageVoxels cage = withShortTwelfthRibs();
            cage = spine ? cage.withVertebrae(1) : cage;
            Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 0));
            assertThat(truth).containsEntry("rib_12_R", 24);
            assertThat(24.0 / truth.get("rib_06_R")).isLessThan(0.05);
            Segmentation common = cage.segmentation(CageVoxels.table(true));
            assertThat(BoneNumbering.numberRibs(common))
                    .singleElement()
                    .asString()
                    .startsWith("ribs: the 24 connected");
            assertThat(CageVoxels.ribCounts(common)).isEqualTo(truth);
            labelFrontOfSecondAsThird(cage);
            Segmentation named = from(cage, 0);
            assertThat(BoneNumbering.numberRibs(named))
                    .singleElement()
                    .asString()
                    .contains("the 24 connected");
            assertThat(CageVoxels.ribCounts(named)).isEqualTo(truth);
        }
    }

    /** A lump beside the spine, and a line as long as a rib that the end of the scan cuts. */
    @Test
    void smallPartsThatAreNoLastRibAreLeftOutWithANote() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 12));
        cage.ball(30, 55, 15, 1.9, CageVoxels.rib(12, true));
        for (int n = 0; n < 24; n++) {
            cage.ball(51 + n, 52, 12, 0.5, CageVoxels.rib(12, false));
        }
        byte[] labels = Arrays.copyOfRange(cage.labels, 12 * SLICE, cage.labels.length);
        Segmentation s = new Segmentation(CageVoxels.volume(labels), CageVoxels.table(true), "scan");
        assertThat(BoneNumbering.numberRibs(s))
                .singleElement()
                .asString()
                .startsWith("ribs: the 24 connected")
                .endsWith("; left out, in small parts away from all ribs: 1.4 ml");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** The eleventh right rib falls so steeply that in most directions it lies below the twelfth, which is level. */
    @Test
    void ribsBesideEachOtherFollowTheirVertebralEnds() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        clear(cage, CageVoxels.rib(11, true));
        clear(cage, CageVoxels.rib(12, true));
        for (int step = 0; step <= 180; step++) {
            double angle = Math.PI * step / 400;
            double x = StrictMath.sin(angle);
            double y = StrictMath.cos(angle);
            cage.ball(38.5 - 36 * x, 30 + 22 * y, 36 - 50 * angle / Math.PI, 1.6, CageVoxels.rib(11, true));
            if (step <= 160) {
                cage.ball(38.5 - 26 * x, 30 + 14 * y, 28, 1.6, CageVoxels.rib(12, true));
            }
        }
        Map<String, Integer> truth = CageVoxels.ribCounts(from(cage, 0));
        Segmentation s = cage.segmentation(CageVoxels.table(true));
        assertThat(s.names()).contains(LabelTable.RIBS);
        BoneNumbering.numberRibs(s);
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }
}
