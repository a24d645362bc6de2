package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/** Lungs under one label as boxes of voxels of 6 mm; a thousand voxels are 216 ml. */
class LungSplitterTest {
    private static final int COLUMNS = 60;
    private static final int ROWS = 30;
    private static final int SLICES = 45;
    private static final double SPACING_MM = 6;

    private final byte[] labels = new byte[COLUMNS * ROWS * SLICES];
    private final List<String> notes = new ArrayList<>();

    private void box(int label, int column, int row, int slice, int wide, int deep, int tall) {
        for (int k = slice; k < slice + tall; k++) {
            for (int j = row; j < row + deep; j++) {
                for (int i = column; i < column + wide; i++) {
                    labels[i + COLUMNS * (j + ROWS * k)] = (byte) label;
                }
            }
        }
    }

    private Segmentation segmentation() {
        return segmentation("lung_L");
    }

    private Segmentation segmentation(String third) {
        double s = SPACING_MM;
        LabelVolume volume = new LabelVolume(
                LabelGrid.of(COLUMNS, ROWS, SLICES, labels, new double[] {s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0}),
                Map.of(),
                List.of());
        return new Segmentation(volume, new LabelTable(Map.of(1, LabelTable.LUNGS, 2, "lung_R", 3, third)), "scan");
    }

    private static int count(Segmentation s, String name) {
        return s.find(name) > 0 ? s.counts()[s.find(name)] : 0;
    }

    private void rightLung(int label) {
        box(label, 4, 5, 5, 20, 20, 30);
    }

    @Test
    void aLungThatHasCollapsedIsToldFromTheOther() {
        rightLung(1);
        box(1, 30, 8, 10, 10, 15, 20);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R")).isEqualTo(20 * 20 * 30);
        assertThat(count(s, "lung_L")).isEqualTo(10 * 15 * 20);
        assertThat(notes).isEmpty();
    }

    @Test
    void aLungThatHasCollapsedIsToldThoughABronchusJoinsItToTheOther() {
        rightLung(1);
        box(1, 30, 8, 10, 10, 15, 20);
        box(1, 24, 14, 20, 6, 2, 2);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R")).isBetween(20 * 20 * 30, 20 * 20 * 30 + 24);
        assertThat(count(s, "lung_L")).isBetween(10 * 15 * 20, 10 * 15 * 20 + 24);
        assertThat(notes).isEmpty();
    }

    /** Gas in the stomach, at the base of the lung, touches it. */
    @Test
    void gasInTheAbdomenThatTouchesTheLungIsNoLung() {
        rightLung(1);
        box(1, 30, 8, 4, 10, 10, 10);
        box(1, 24, 12, 8, 6, 2, 2);
        assertThat(LungSplitter.split(segmentation(), notes).orElseThrow())
                .contains("found one body that parts into two side by side of 2595 and 219 ml, of which the second is");
    }

    @Test
    void aLungThatHasCollapsedIsToldBesideALabelOfTheOther() {
        rightLung(2);
        box(1, 30, 8, 20, 9, 10, 10);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R")).isEqualTo(20 * 20 * 30);
        assertThat(count(s, "lung_L")).isEqualTo(9 * 10 * 10);
    }

    /** Gas in the stomach lies on the other side as well, at the base of the lung. */
    @Test
    void gasInTheAbdomenIsNoLung() {
        rightLung(1);
        box(1, 30, 8, 4, 10, 10, 10);
        Segmentation s = segmentation();
        Optional<String> problem = LungSplitter.split(s, notes);
        assertThat(problem.orElseThrow())
                .contains("found a body of 2592 ml that does not part into two, and one of 216 ml");
        assertThat(count(s, LabelTable.LUNGS)).isEqualTo(13_000);
    }

    /** Both lungs in one body part as before, whatever lies apart from them; that is left out with a note. */
    @Test
    void whatLiesApartFromBothLungsIsLeftOutWithANote() {
        rightLung(1);
        box(1, 24, 14, 20, 8, 2, 2);
        box(1, 32, 5, 5, 18, 20, 30);
        box(1, 52, 10, 15, 8, 10, 15);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R") + count(s, "lung_L")).isEqualTo(12_000 + 32 + 10_800);
        assertThat(notes).singleElement().asString().startsWith("lungs: 259 ml that lie apart from both lungs");
    }

    /** A lobe with a label of its own is a piece of its lung, whether the lungs touch or not and on either side. */
    @ParameterizedTest
    @CsvSource({"lung_L, 52, 24", "lung_L, 52, 21", "lung_R, 0, 24", "lung_R, 0, 21"})
    void aLobeUnderALabelOfItsOwnIsAPieceOfItsLung(String lobe, int column, int bridge) {
        rightLung(1);
        box(1, bridge, 14, 20, 8, 2, 2);
        box(1, 32, 5, 5, 18, 20, 30);
        int joined = bridge == 24 ? 4 * 8 : 4 * 5;
        box(3, column, 10, 15, 3, 10, 15);
        Segmentation s = segmentation(lobe);
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R") + count(s, "lung_L")).isEqualTo(12_000 + joined + 10_800 + 450);
        assertThat(count(s, "lung_R")).isBetween(12_000, 12_000 + joined + 450);
        assertThat(count(s, "lung_L")).isBetween(10_800, 10_800 + joined + 450);
        assertThat(count(s, lobe)).isGreaterThanOrEqualTo("lung_R".equals(lobe) ? 12_450 : 11_250);
        assertThat(s.labels(lobe)).containsExactly(1, 3);
        assertThat(notes).isEmpty();
    }

    /** The other lung, in lobes apart, is no pair of lungs beside a whole lung, nor beside a collapsed one. */
    @ParameterizedTest
    @CsvSource({"4, 20, 30", "14, 8, 12"})
    void lobesOfTheOtherLungStayOnTheirSide(int column, int wide, int tall) {
        box(2, column, 5, 5, wide, 20, tall);
        box(1, 30, 5, 3, 18, 20, 18);
        box(1, 36, 5, 24, 18, 20, 16);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R")).isEqualTo(wide * 20 * tall);
        assertThat(count(s, "lung_L")).isEqualTo(18 * 20 * 34);
        assertThat(notes).isEmpty();
    }

    /** Upper and middle lobe of the right lung have a label; its lower lobe shares one with the left lung. */
    @Test
    void aLobeApartBelowTheLabelledLungIsAPieceOfThat() {
        box(2, 4, 5, 22, 20, 20, 15);
        box(1, 4, 5, 8, 20, 20, 12);
        box(1, 30, 5, 8, 18, 20, 24);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R")).isEqualTo(20 * 20 * 27);
        assertThat(count(s, "lung_L")).isEqualTo(18 * 20 * 24);
        assertThat(s.labels("lung_R")).containsExactly(1, 2);
        assertThat(notes).isEmpty();
    }

    @Test
    void aLungThatReachesInFrontOfTheLabelledOneIsTheOther() {
        box(2, 4, 5, 5, 12, 20, 30);
        box(1, 8, 0, 5, 9, 4, 30);
        box(1, 17, 0, 5, 18, 25, 30);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes)).isEmpty();
        assertThat(count(s, "lung_R")).isEqualTo(12 * 20 * 30);
        assertThat(count(s, "lung_L")).isEqualTo(9 * 4 * 30 + 18 * 25 * 30);
        assertThat(notes).isEmpty();
    }

    /** The lobes of one lung lie apart where fluid fills the fissure between them. */
    @Test
    void lobesOneAboveTheOtherAreNoTwoLungs() {
        box(1, 10, 5, 3, 18, 20, 16);
        box(1, 10, 5, 23, 18, 20, 16);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes).orElseThrow()).contains("does not lie beside it, expected both lungs");
        assertThat(count(s, LabelTable.LUNGS)).isEqualTo(2 * 18 * 20 * 16);
    }

    /** A lung with a waist parts into an upper and a lower half, which are no lungs of two sides. */
    @Test
    void theHalvesOfOneLungAreNoTwoLungs() {
        box(1, 10, 5, 3, 18, 20, 16);
        box(1, 16, 12, 19, 4, 4, 4);
        box(1, 10, 5, 23, 18, 20, 16);
        Segmentation s = segmentation();
        assertThat(LungSplitter.split(s, notes).orElseThrow())
                .contains("found one body that does not part into two side by side, expected both lungs");
    }
}
