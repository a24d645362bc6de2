package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/** Parts of 24 voxels, a thirtieth of the usual rib, below the last of ribs under one label. */
class ShortRibsTest {
    private static final int SLICE = CageVoxels.COLUMNS * CageVoxels.ROWS;
    /** The slices below show no upper ribs. */
    private static final int ABDOMEN = 84;

    private static Segmentation scan(CageVoxels cage, int slices, boolean common) {
        byte[] labels = Arrays.copyOf(cage.labels, slices * SLICE);
        return new Segmentation(CageVoxels.volume(labels), CageVoxels.table(common), "scan");
    }

    /** Adds a straight part that begins beside the spine, as long as so many voxels. */
    private static void part(CageVoxels cage, int row, int slice, int length, boolean right) {
        for (int n = 0; n < length; n++) {
            for (int y = row; y < row + 24 / length; y++) {
                double x = 44.5 + (right ? -1 : 1) * (6.5 + n);
                cage.ball(x, y, slice - n / 6, 0.5, CageVoxels.rib(12, right));
            }
        }
    }

    /** As a rib of the first lumbar vertebra or its transverse process, on one side or both. */
    @Test
    void aShortRibOfALumbarVertebraIsNoLastRib() {
        for (int slices : new int[] {CageVoxels.SLICES, ABDOMEN}) {
            CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
            Map<String, Integer> truth = CageVoxels.ribCounts(scan(cage, slices, false));
            for (boolean right : new boolean[] {true, false}) {
                part(cage, 52, 16, 12, right);
                Segmentation s = scan(cage, slices, true);
                assertThat(BoneNumbering.numberRibs(s))
                        .singleElement()
                        .asString()
                        .startsWith("ribs: the " + truth.size() + " connected ribs")
                        .contains("left out, in small parts");
                assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
            }
        }
    }

    @Test
    void belowATwelfthRibThereIsNoLastRibWithoutVertebrae() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        Map<String, Integer> truth = CageVoxels.ribCounts(scan(cage, ABDOMEN, false));
        part(cage, 52, 16, 24, true);
        Segmentation s = scan(cage, ABDOMEN, true);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().contains(", counted from the last");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** The twelfth rib is as long as the eleventh. */
    @Test
    void belowTwelveRibsThereIsNoLastRib() {
        CageVoxels cage = new CageVoxels().withRibs(1);
        Map<String, Integer> truth = CageVoxels.ribCounts(scan(cage, CageVoxels.SLICES, false));
        part(cage, 52, 16, 24, true);
        Segmentation s = scan(cage, CageVoxels.SLICES, true);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().startsWith("ribs: the 24 connected");
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    private static CageVoxels withoutTwelfth() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean last = label == CageVoxels.rib(12, true) || label == CageVoxels.rib(12, false);
            cage.labels[v] = last ? 0 : cage.labels[v];
        }
        return cage;
    }

    /** 6 mm below the end of the eleventh, behind it. */
    @Test
    void aPartBesideTheEndOfARibIsAFragmentOfIt() {
        CageVoxels cage = withoutTwelfth().withVertebrae(1);
        Map<String, Integer> truth = CageVoxels.ribCounts(scan(cage, CageVoxels.SLICES, false));
        part(cage, 56, 34, 24, true);
        Segmentation s = scan(cage, CageVoxels.SLICES, true);
        BoneNumbering.numberRibs(s);
        truth.merge("rib_11_R", 24, Integer::sum);
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** 57 or 63 mm below the eleventh. */
    @Test
    void aPartFarBelowTheOthersIsNoLastRib() {
        for (int slice : new int[] {17, 15}) {
            CageVoxels cage = withoutTwelfth();
            Map<String, Integer> truth = CageVoxels.ribCounts(scan(cage, ABDOMEN, false));
            part(cage, 52, slice, 24, true);
            Segmentation s = scan(cage, ABDOMEN, true);
            assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().contains("counted from the last");
            if (slice > 15) {
                truth.put("rib_12_R", 24);
            }
            assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
        }
    }
}
