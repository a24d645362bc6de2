package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/**
 * Lower ribs of a tall man, whose spine has labels from the last thoracic or a lumbar vertebra on: ribs end 29 mm from
 * each other, the first lumbar vertebra lies 32 mm below the twelfth thoracic one.
 */
class LumbarRibsTest {
    private static final String STERNUM = "sternum";
    private static final double SLICE_MM = 3.6;
    /** Slices from the vertebra at the end of the twelfth rib to the first lumbar one, and from each to the next. */
    private static final int LUMBAR_SLICES = 9;

    private static final int ROW = CageVoxels.COLUMNS * CageVoxels.ROWS;
    /** The slice through the heads of rib 8 at which a scan ends. */
    private static final int CUT = 58;

    /** Adds the vertebra so many levels below the twelfth thoracic one, under the label of that one. */
    private static CageVoxels withVertebra(CageVoxels cage, int below) {
        cage.ball(44.5, 50, 123 - 8 * 12 - LUMBAR_SLICES * below, 3.2, CageVoxels.vertebra(12));
        return cage;
    }

    /** The slices of a cage up to one of them, with a name for the vertebra and one or many labels for the ribs. */
    private static Segmentation scan(CageVoxels cage, int slices, String vertebra, boolean common) {
        TreeMap<Integer, String> table = new TreeMap<>(CageVoxels.table(common).structures());
        table.put(CageVoxels.vertebra(12), vertebra);
        byte[] labels = Arrays.copyOf(cage.labels, slices * ROW);
        return new Segmentation(CageVoxels.volume(labels, SLICE_MM), new LabelTable(table), "scan");
    }

    private static TreeMap<String, Integer> truth(CageVoxels cage, int slices) {
        return CageVoxels.ribCounts(scan(cage, slices, STERNUM, false));
    }

    private static void assertNumbered(Segmentation s, String by, TreeMap<String, Integer> truth) {
        assertThat(BoneNumbering.numberRibs(s)).singleElement().satisfies(note -> assertThat(note)
                .endsWith(by));
        assertThat(CageVoxels.ribCounts(s)).isEqualTo(truth);
    }

    /** As in a scan of the abdomen; so are they without any vertebra. */
    @Test
    void ribsThatAScanCutsAboveAreCountedFromTheLastBesideLumbarVertebrae() {
        for (int below = 1; below <= 2; below++) {
            CageVoxels cage = withVertebra(CageVoxels.withFloatingRibs(), below);
            TreeMap<String, Integer> truth = truth(cage, CUT);
            assertThat(truth).containsKeys("rib_08_R", "rib_12_L");
            assertNumbered(scan(cage, CUT, "vertebra_L0" + below, true), ", counted from the last", truth);
        }
    }

    /** Of the left side the labels hold ribs 9 to 12 alone, none of which the scan cuts. */
    @Test
    void eachSideIsNumberedByWhatTellsItsOwnNumbers() {
        CageVoxels cage = withVertebra(CageVoxels.withFloatingRibs(), 1);
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean upper = label >= CageVoxels.rib(1, false) && label < CageVoxels.rib(9, false);
            cage.labels[v] = upper ? 0 : cage.labels[v];
        }
        assertNumbered(
                scan(cage, CUT, "vertebra_L01", true),
                ", counted from the last on the right and by their vertebrae on the left",
                truth(cage, CUT));
    }

    @Test
    void wholeLowerRibsAreNumberedByALumbarVertebra() {
        for (int below = 1; below <= 2; below++) {
            CageVoxels cage = withVertebra(new CageVoxels().withRibs(4), below);
            Segmentation s = scan(cage, CageVoxels.SLICES, "vertebra_L0" + below, true);
            assertNumbered(s, " by their vertebrae", truth(cage, CageVoxels.SLICES));
        }
    }

    /** Those of the left side end with the eleventh. */
    @Test
    void theLastThoracicVertebraAloneNumbersThemAsWell() {
        CageVoxels cage = new CageVoxels().withRibs(4);
        for (int v = 0; v < cage.labels.length; v++) {
            boolean last = (cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.rib(12, false);
            cage.labels[v] = last ? 0 : cage.labels[v];
        }
        withVertebra(cage, 0);
        for (int slices : new int[] {CUT, CageVoxels.SLICES}) {
            assertNumbered(scan(cage, slices, "vertebra_T12", true), " by their vertebrae", truth(cage, slices));
        }
    }

    /** The voxels of right rib 9 carry the number of rib 8, and of the spine the second lumbar vertebra has a label. */
    @Test
    void lumbarVertebraeDoNotOverruleTheNumbersOfLabels() {
        CageVoxels cage = withVertebra(new CageVoxels().withRibs(7), 2);
        TreeMap<String, Integer> truth = truth(cage, CageVoxels.SLICES);
        for (int v = 0; v < cage.labels.length; v++) {
            boolean wrong = (cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.rib(9, true);
            cage.labels[v] = wrong ? (byte) CageVoxels.rib(8, true) : cage.labels[v];
        }
        assertNumbered(scan(cage, CageVoxels.SLICES, "vertebra_L02", false), "from top to bottom", truth);
    }

    /** All ribs of a side are there, or those of the left side alone; or a scan cuts the ribs of one side. */
    @Test
    void theNoteSaysFromWhereTheRibsOfEachSideAreCounted() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        assertThat(note(cage, 0, List.of(true, false))).endsWith("from top to bottom");
        assertThat(note(cage, 0, List.of(false))).endsWith("from top to bottom");
        int upper = 62;
        assertThat(note(cage, upper, List.of(true, false))).endsWith(", counted from the first");
        assertThat(note(cage, upper, List.of(false))).endsWith(", counted from the first");
        assertThat(note(cage, upper, List.of(true))).endsWith(", counted from the first");
    }

    /** The note on the ribs of some sides, which have a label for each side, from a slice on. */
    private static String note(CageVoxels cage, int from, List<Boolean> sides) {
        byte[] labels = Arrays.copyOfRange(cage.labels, from * ROW, cage.labels.length);
        TreeMap<Integer, String> table = new TreeMap<>();
        Set<Integer> shown = new TreeSet<>();
        for (boolean right : sides) {
            for (int number = 1; number <= 12; number++) {
                shown.add(CageVoxels.rib(number, right));
                table.put(CageVoxels.rib(number, right), right ? LabelTable.RIGHT_RIBS : LabelTable.LEFT_RIBS);
            }
        }
        for (int v = 0; v < labels.length; v++) {
            labels[v] = shown.contains(labels[v] & LabelGrid.MAX_BYTE_LABEL) ? labels[v] : 0;
        }
        Segmentation s = new Segmentation(CageVoxels.volume(labels), new LabelTable(table), "scan");
        return BoneNumbering.numberRibs(s).get(0);
    }
}
