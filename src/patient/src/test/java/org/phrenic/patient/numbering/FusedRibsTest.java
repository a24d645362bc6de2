package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/** A cage whose ribs hang together under a label that several share. */
class FusedRibsTest {
    private static final double MIDDLE = 44.5;
    /** Label of what joins ribs. */
    private static final int JOINT = 1;

    private static final int RIGHT = 2;

    private static final int FIRST_FUSED = 7;
    private static final int LAST_FUSED = 10;

    /** Joins the front ends of ribs 7 to 10 of both sides by a cartilage under the ribs' label. */
    private static CageVoxels withMargins() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        for (double z = front(LAST_FUSED); z <= front(FIRST_FUSED); z += 0.5) {
            cage.ball(MIDDLE - 9, 9, z, 2.2, JOINT);
            cage.ball(MIDDLE + 9, 9, z, 2.2, JOINT);
        }
        return cage;
    }

    /** Slice of the front end of a rib. */
    private static double front(int number) {
        return 124 - 8 * number - 12;
    }

    /** Joins right ribs 5 and 6 at a share of their length from the spine. */
    private static void bridge(CageVoxels cage, double share) {
        double angle = Math.PI * share;
        double x = MIDDLE - 36 * StrictMath.sin(angle) - 6;
        double y = 30 + 22 * StrictMath.cos(angle);
        for (double z = 124 - 8 * 6; z <= 124 - 8 * 5; z += 0.5) {
            cage.ball(x, y, z - 12 * share, 1.6, JOINT);
        }
    }

    /** The scan of a cage whose ribs share the labels of two structures, one of each side. */
    private static Segmentation scan(CageVoxels cage, String rightRibs, String leftRibs) {
        byte[] labels = cage.labels.clone();
        Map<Integer, String> table = new TreeMap<>(CageVoxels.table(true).structures());
        table.put(JOINT, leftRibs);
        table.put(RIGHT, rightRibs);
        for (int v = 0; v < labels.length; v++) {
            int label = labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean rib = label > 0 && table.get(label).startsWith(LabelTable.RIBS);
            labels[v] = rib ? (byte) (v % CageVoxels.COLUMNS < MIDDLE ? RIGHT : JOINT) : labels[v];
        }
        return new Segmentation(CageVoxels.volume(labels), new LabelTable(table), "scan");
    }

    /** Voxels of the ribs that have their own name, over all of theirs in the cage. */
    private static double named(Segmentation s, CageVoxels cage) {
        Map<Integer, String> truth = CageVoxels.table(false).structures();
        int named = 0;
        int all = 0;
        for (int v = 0; v < s.voxels().length; v++) {
            double[] at = s.point(v);
            int label = cage.at(
                    (int) Math.round(at[0] / CageVoxels.SPACING_MM),
                    (int) Math.round(at[1] / CageVoxels.SPACING_MM),
                    (int) Math.round(at[2] / CageVoxels.SPACING_MM));
            if (label > JOINT && truth.get(label).startsWith("rib")) {
                all++;
                named += s.segmentAt(v) == s.find(truth.get(label)) ? 1 : 0;
            }
        }
        return named / (double) all;
    }

    @Test
    void ribsOfASideThatShareTheirMarginAreNumberedByTheirVertebrae() {
        CageVoxels cage = withMargins().withVertebrae(1);
        Segmentation s = scan(cage, LabelTable.RIGHT_RIBS, LabelTable.LEFT_RIBS);
        assertThat(BoneNumbering.numberRibs(s))
                .containsExactly("ribs: the 24 connected ribs are numbered from top to bottom by their vertebrae; ribs"
                        + " that hang together are parted: 4 on the right in front, 4 on the left in front");
        assertThat(named(s, cage)).isGreaterThan(0.99);
    }

    @Test
    void withoutVertebraeAllTwelveAreNumberedUnderOneLabel() {
        CageVoxels cage = withMargins();
        Segmentation s = scan(cage, LabelTable.RIBS, LabelTable.RIBS);
        BoneNumbering.numberRibs(s);
        assertThat(named(s, cage)).isGreaterThan(0.99);
    }

    /** Each front half stays with its back half, of which that of the rib below is as near. */
    @Test
    void ribsJoinedBySomeBoneHalfWayGoOnBeyondIt() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        bridge(cage, 0.5);
        Segmentation s = scan(cage, LabelTable.RIBS, LabelTable.RIBS);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().endsWith(": 2 on the right at the side");
        assertThat(named(s, cage)).isGreaterThan(0.99);
    }

    @Test
    void ribsThatHangTogetherAlongTheirLengthAreRefused() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        for (int n = 1; n < 10; n++) {
            bridge(cage, n / 10.0);
        }
        Segmentation s = scan(cage, LabelTable.RIGHT_RIBS, LabelTable.LEFT_RIBS);
        assertThatThrownBy(() -> BoneNumbering.numberRibs(s))
                .isInstanceOf(BadInputException.class)
                .hasMessage(
                        "ribs_R: found 2 ribs on the right that hang together at the side about (36, 129, 219) mm and"
                                + " cannot be parted, expected gaps between ribs, with cartilages under a label of their own,"
                                + " or a label for each rib");
    }
}
