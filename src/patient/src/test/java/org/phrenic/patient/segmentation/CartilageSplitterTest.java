package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

class CartilageSplitterTest {
    private static final int COLUMNS = 30;
    /** Columns of a scan whose upper cartilage has 1000 of them. */
    private static final int WIDE = 1100;

    private static final int ROWS = 6;
    private static final int SLICES = 12;
    private static final double THICK_MM = 5;
    private static final LabelTable TABLE =
            new LabelTable(Map.of(1, "rib_06_R", 2, "rib_07_R", 3, LabelTable.COSTAL_CARTILAGES));

    private final byte[] labels = new byte[COLUMNS * ROWS * SLICES];

    private void bar(int from, int to, int slice, int label) {
        for (int row = 0; row < ROWS; row++) {
            for (int column = from; column < to; column++) {
                labels[column + COLUMNS * (row + ROWS * slice)] = (byte) label;
            }
        }
    }

    private Segmentation split(double sliceMm) {
        double[] toMm = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, sliceMm, 0};
        Segmentation s = new Segmentation(
                new LabelVolume(LabelGrid.of(COLUMNS, ROWS, SLICES, labels, toMm), Map.of(), List.of()), TABLE, "scan");
        assertThat(CartilageSplitter.split(s)).isEmpty();
        return s;
    }

    private static int count(Segmentation s, String name) {
        int segment = s.find(name);
        return segment > 0 ? s.counts()[segment] : 0;
    }

    /**
     * Two ribs 10 mm apart in slices of 5 mm; the end of the upper one lies above the beginning of the lower one's
     * cartilage.
     */
    @Test
    void aCartilageBelowTheEndOfTheRibAboveBelongsToItsOwnRib() {
        bar(0, 13, 7, 1);
        bar(13, COLUMNS, 7, 3);
        bar(0, 11, 5, 2);
        bar(11, COLUMNS, 5, 3);
        Segmentation s = split(THICK_MM);
        assertThat(count(s, "costal_cartilage_06_R")).isEqualTo((COLUMNS - 13) * ROWS);
        assertThat(count(s, "costal_cartilage_07_R")).isEqualTo((COLUMNS - 11) * ROWS);
    }

    /** A slice between rib and cartilage, as segmentation tools leave: the cartilage is the rib's. */
    @Test
    void aCartilageOneThickSliceBelowItsRibBelongsToIt() {
        bar(0, 13, 7, 1);
        bar(0, 11, 2, 2);
        bar(12, COLUMNS, 6, 3);
        assertThat(count(split(THICK_MM), "costal_cartilage_06_R")).isEqualTo((COLUMNS - 12) * ROWS);
    }

    private Segmentation wide(int fragmentColumns, int pieceColumns) {
        byte[] wide = new byte[WIDE * ROWS * SLICES];
        for (int row = 0; row < ROWS; row++) {
            int slice7 = WIDE * (row + ROWS * 7);
            Arrays.fill(wide, slice7, slice7 + 100, (byte) 1);
            Arrays.fill(wide, slice7 + 100, slice7 + WIDE, (byte) 3);
            int slice2 = WIDE * row;
            Arrays.fill(wide, slice2, slice2 + 100, (byte) 2);
            Arrays.fill(wide, slice2 + 103, slice2 + 103 + fragmentColumns, (byte) 3);
            Arrays.fill(wide, slice2 + 108, slice2 + 108 + pieceColumns, (byte) 3);
        }
        double[] toMm = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, THICK_MM, 0};
        return new Segmentation(
                new LabelVolume(LabelGrid.of(WIDE, ROWS, SLICES, wide, toMm), Map.of(), List.of()), TABLE, "scan");
    }

    /** Scans show some cartilages in part, apart from their ribs and in fragments. */
    @Test
    void aSmallLoosePieceNearARibWithoutCartilageIsItsCartilage() {
        Segmentation s = wide(0, 6);
        assertThat(CartilageSplitter.split(s)).isEmpty();
        assertThat(count(s, "costal_cartilage_07_R")).isEqualTo(6 * ROWS);
        Segmentation fragment = wide(3, 6);
        assertThat(CartilageSplitter.split(fragment).orElseThrow()).contains("0.3 % of it left out");
        assertThat(count(fragment, "costal_cartilage_07_R")).isEqualTo(6 * ROWS);
        assertThat(count(fragment, "costal_cartilage_06_R")).isEqualTo((WIDE - 100) * ROWS);
    }

    @Test
    void aSpeckOfCartilageIsNoneAndNotWorthANote() {
        Segmentation s = wide(0, 1);
        assertThat(CartilageSplitter.split(s)).isEmpty();
        assertThat(s.find("costal_cartilage_07_R")).isNotPositive();
    }
}
