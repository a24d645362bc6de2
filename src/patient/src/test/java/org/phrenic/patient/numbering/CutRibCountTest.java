package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Locale;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/** A cage of ribs under one label, without vertebrae, of which a scan shows the slices from one to another. */
class CutRibCountTest {
    private static final int ROW = CageVoxels.COLUMNS * CageVoxels.ROWS;

    private static Segmentation scan(CageVoxels cage, int from, int to, boolean common) {
        byte[] labels = new byte[(to - from) * ROW];
        System.arraycopy(cage.labels, from * ROW, labels, 0, labels.length);
        return new Segmentation(CageVoxels.volume(labels), CageVoxels.table(common), "scan");
    }

    /** Voxels of each rib by its name. */
    private static TreeMap<String, Integer> numbered(CageVoxels cage, int from, int to, boolean common) {
        Segmentation s = scan(cage, from, to, common);
        BoneNumbering.numberRibs(s);
        TreeMap<String, Integer> counts = new TreeMap<>();
        int[] all = s.counts();
        for (String name : s.names()) {
            if (all[s.find(name)] > 0 && !name.equals(LabelTable.RIBS)) {
                counts.put(name, all[s.find(name)]);
            }
        }
        return counts;
    }

    private static String name(int number, boolean right) {
        return String.format(Locale.ROOT, "rib_%02d_%s", number, right ? "R" : "L");
    }

    /** The slices end at 58, through the heads of rib 8; the fronts of ribs 7 and 8 are parts of their own. */
    @Test
    void ribsThatAScanCutsAboveAreCountedFromTheTwelfth() {
        TreeMap<String, Integer> truth = numbered(CageVoxels.withFloatingRibs(), 0, 58, false);
        assertThat(truth).containsKeys(name(7, true), name(8, false), name(12, true));
        assertThat(numbered(CageVoxels.withFloatingRibs(), 0, 58, true)).isEqualTo(truth);
    }

    @Test
    void withoutATwelfthRibTheyAreCountedFromTheEleventh() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        cage.shorten(12, CageVoxels.ROWS);
        assertThat(numbered(cage, 0, 58, true)).isEqualTo(numbered(cage, 0, 58, false));
    }

    /**
     * The left twelfth rib is longer than 0.73 of the eleventh, the right one is not; both end at the height of the
     * twelfth vertebra.
     */
    @Test
    void lastRibsThatEndAtOneHeightHaveOneNumberWhateverTheirLengths() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        CageVoxels longer = new CageVoxels().withRibs(1);
        longer.shorten(12, 28);
        for (int v = 0; v < cage.labels.length; v++) {
            if ((longer.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.rib(12, false)) {
                cage.labels[v] = longer.labels[v];
            }
        }
        TreeMap<String, Integer> truth = numbered(cage, 0, 58, false);
        assertThat(truth).containsKeys(name(12, true), name(12, false));
        assertThat(numbered(cage, 0, 58, true)).isEqualTo(truth);
    }

    /** The left side has eleven ribs, of which the last ends one vertebra above the right twelfth. */
    @Test
    void lastRibsThatEndAtTwoHeightsHaveTheirOwnNumbers() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        for (int v = 0; v < cage.labels.length; v++) {
            if ((cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.rib(12, false)) {
                cage.labels[v] = 0;
            }
        }
        assertThat(numbered(cage, 0, 58, true)).isEqualTo(numbered(cage, 0, 58, false));
    }

    @Test
    void ribsThatAScanCutsBelowAreCountedFromTheFirst() {
        TreeMap<String, Integer> truth = numbered(CageVoxels.withFloatingRibs(), 62, CageVoxels.SLICES, false);
        assertThat(truth).containsKey(name(1, true)).doesNotContainKey(name(12, true));
        assertThat(numbered(CageVoxels.withFloatingRibs(), 62, CageVoxels.SLICES, true))
                .isEqualTo(truth);
    }

    @Test
    void ribsOfASlabAreNotCounted() {
        assertThatThrownBy(() -> numbered(CageVoxels.withFloatingRibs(), 50, 70, true))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("and no vertebrae, expected 12, or labelled vertebrae");
    }
}
