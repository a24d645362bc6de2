package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/** A cage whose ribs share a label, or of which a scan shows one side. */
class RibSidesTest {
    private static final String STERNUM = "sternum";
    private static final int STERNUM_LABEL = 1;

    /** The cage without the ribs of a side. */
    private static CageVoxels oneSide(CageVoxels cage, boolean right) {
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean other = label >= CageVoxels.rib(1, !right) && label <= CageVoxels.rib(12, !right);
            cage.labels[v] = other ? 0 : cage.labels[v];
        }
        return cage;
    }

    /** Divides a rib at two fifths of its length from the spine. */
    private static CageVoxels withBroken(CageVoxels cage, int number, boolean right) {
        for (int v = 0; v < cage.labels.length; v++) {
            int row = v / CageVoxels.COLUMNS % CageVoxels.ROWS;
            boolean gap = row >= 36 && row <= 38;
            boolean broken = (cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.rib(number, right);
            cage.labels[v] = gap && broken ? 0 : cage.labels[v];
        }
        return cage;
    }

    /** From the fourth right rib on each has the label of the next one, and the last has none. */
    @Test
    void ribsWhoseLabelsLeaveOutANumberAreNumberedByTheirVertebrae() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        byte[] truth = cage.labels.clone();
        for (int v = 0; v < truth.length; v++) {
            int label = truth[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean slipped = label >= CageVoxels.rib(4, true) && label <= CageVoxels.rib(11, true);
            boolean last = label == CageVoxels.rib(12, true);
            cage.labels[v] = last ? 0 : slipped ? (byte) (label + 1) : truth[v];
        }
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(BoneNumbering.numberRibs(s)).singleElement().satisfies(note -> assertThat(note)
                .startsWith("labels 106 and 108 leave out a number, though no rib is missing between them:"));
        Map<Integer, String> names = CageVoxels.table(false).structures();
        Map<String, Set<String>> found = new TreeMap<>();
        for (int v = 0; v < s.voxels().length; v++) {
            int[] at = new int[3];
            for (int axis = 0; axis < 3; axis++) {
                at[axis] = (int) Math.round(s.coordinate(v, axis) / CageVoxels.SPACING_MM);
            }
            int label = truth[at[0] + CageVoxels.COLUMNS * (at[1] + CageVoxels.ROWS * at[2])];
            String name = names.getOrDefault(label & LabelGrid.MAX_BYTE_LABEL, "");
            if (name.startsWith("rib") && s.segmentAt(v) > 0) {
                found.computeIfAbsent(name, n -> new TreeSet<>()).add(s.names().get(s.segmentAt(v) - 1));
            }
        }
        assertThat(found).hasSize(23).allSatisfy((name, numbered) -> assertThat(numbered)
                .containsExactly(name));
    }

    @Test
    void ribsBesideAMissingOneKeepTheirNumbers() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            cage.labels[v] = label == CageVoxels.rib(4, true) ? 0 : cage.labels[v];
        }
        assertThat(BoneNumbering.numberRibs(cage.segmentation(CageVoxels.table(false))))
                .isEmpty();
    }

    /** Names of the structures after ribs are numbered, with all ribs of the cage under one name. */
    private static Set<String> named(CageVoxels cage, String ribs) {
        TreeMap<Integer, String> table = new TreeMap<>(CageVoxels.table(true).structures());
        table.replaceAll((label, name) -> name.equals(LabelTable.RIBS) ? ribs : name);
        table.put(STERNUM_LABEL, STERNUM);
        Segmentation s = cage.segmentation(new LabelTable(table));
        BoneNumbering.numberRibs(s);
        Set<String> names = new TreeSet<>();
        int[] counts = s.counts();
        s.names().stream().filter(name -> counts[s.find(name)] > 0).forEach(names::add);
        names.removeIf(name -> !name.startsWith("rib"));
        return names;
    }

    private static Set<String> ribs(boolean right, int first) {
        Set<String> names = new TreeSet<>();
        for (int number = first; number <= 12; number++) {
            names.add(CageVoxels.table(false).structures().get(CageVoxels.rib(number, right)));
        }
        return names;
    }

    @Test
    void ribsUnderTheNameOfTheirSideStayThere() {
        for (boolean right : new boolean[] {true, false}) {
            String name = right ? LabelTable.RIGHT_RIBS : LabelTable.LEFT_RIBS;
            assertThat(named(oneSide(CageVoxels.withFloatingRibs(), right), name))
                    .isEqualTo(ribs(right, 1));
        }
    }

    @Test
    void ribsOfOneSideUnderOneLabelLieBesideTheSpine() {
        for (boolean right : new boolean[] {true, false}) {
            CageVoxels cage = oneSide(CageVoxels.withFloatingRibs(), right).withVertebrae(1);
            assertThat(named(cage, LabelTable.RIBS)).isEqualTo(ribs(right, 1));
        }
    }

    @Test
    void withoutASpineTheyLieBesideTheSternum() {
        for (boolean right : new boolean[] {true, false}) {
            CageVoxels cage = oneSide(CageVoxels.withFloatingRibs(), right);
            cage.ball(44.5, 8, 90, 4, STERNUM_LABEL);
            assertThat(named(cage, LabelTable.RIBS)).isEqualTo(ribs(right, 1));
        }
    }

    /**
     * Half of a broken rib lies farther from the median plane than the middle of its side's ribs, half of it nearer.
     */
    @Test
    void aBrokenRibIsOneWhereAScanShowsRibsOfOneSide() {
        for (boolean right : new boolean[] {true, false}) {
            CageVoxels cage = withBroken(oneSide(CageVoxels.withFloatingRibs(), right), 6, right);
            assertThat(named(cage, right ? LabelTable.RIGHT_RIBS : LabelTable.LEFT_RIBS))
                    .isEqualTo(ribs(right, 1));
            assertThat(named(cage.withVertebrae(1), LabelTable.RIBS)).isEqualTo(ribs(right, 1));
        }
    }

    /** Their labels number them: no rib is numbered anew. */
    @Test
    void aBrokenRibOfOneSideKeepsTheNumberOfItsLabel() {
        CageVoxels cage = withBroken(oneSide(CageVoxels.withFloatingRibs(), true), 6, true);
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
    }

    /** A wrong side is worse than none. */
    @Test
    void ribsOfOneSideWhoseSideNothingTellsAreRefused() {
        assertThatThrownBy(() -> named(oneSide(CageVoxels.withFloatingRibs(), true), LabelTable.RIBS))
                .isInstanceOf(BadInputException.class)
                .hasMessage("ribs: found neither spine nor sternum between ribs of one label, expected one of them,"
                        + " ribs of both sides, or the names ribs_R and ribs_L");
    }

    /** An abdominal scan with ribs 8 to 12, in which a speck of rib 9 lies within the ribs of the other side. */
    @Test
    void aSpeckIsNoRibWhereAScanShowsFewRibs() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean upper = (label >= CageVoxels.rib(1, false) && label < CageVoxels.rib(8, false))
                    || (label >= CageVoxels.rib(1, true) && label < CageVoxels.rib(8, true));
            cage.labels[v] = upper ? 0 : cage.labels[v];
        }
        cage.withVertebrae(8).ball(78, 36, 44, 2.2, CageVoxels.rib(9, true));
        // As many specks in the soft tissue as the scan shows ribs.
        for (int i = 0; i < 12; i++) {
            cage.ball(20 + 4 * i, 22, 10 + 2 * (i % 3), 1.8, CageVoxels.rib(9, true));
        }
        Set<String> both = ribs(true, 8);
        both.addAll(ribs(false, 8));
        assertThat(named(cage, LabelTable.RIBS)).isEqualTo(both);
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
    }

    /** A field of view that shows the whole right side, and of the left one the backs of ribs 10 to 12. */
    @Test
    void aFewRibsOfTheOtherSideDoNotMoveTheMedianPlane() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean upper = label >= CageVoxels.rib(1, false) && label < CageVoxels.rib(10, false);
            boolean outside = v % CageVoxels.COLUMNS > 66 || v / CageVoxels.COLUMNS % CageVoxels.ROWS < 30;
            cage.labels[v] = upper || (outside && label <= CageVoxels.rib(12, false)) ? 0 : cage.labels[v];
        }
        cage.withVertebrae(1);
        Set<String> both = ribs(true, 1);
        both.addAll(ribs(false, 10));
        assertThat(named(cage, LabelTable.RIBS)).isEqualTo(both);
    }
}
