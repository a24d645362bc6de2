package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/** A left lung whose lobes lie apart. */
class LungPiecesTest {
    private static final int COLUMNS = 40;
    private static final int SLICE = 10 * COLUMNS;

    /** Blocks of columns under the label of the left lung. */
    private static Segmentation lung(int... firstAndEnd) {
        return lungs(COLUMNS, COLUMNS, firstAndEnd);
    }

    /** The same and one block under the label of the right lung. */
    private static Segmentation lungs(int first, int end, int... firstAndEnd) {
        byte[] labels = new byte[10 * SLICE];
        for (int v = 0; v < labels.length; v++) {
            int i = v % COLUMNS;
            labels[v] = (byte) (i >= first && i < end ? 2 : 0);
            for (int block = 0; block < firstAndEnd.length; block += 2) {
                labels[v] = i >= firstAndEnd[block] && i < firstAndEnd[block + 1] ? 1 : labels[v];
            }
        }
        LabelVolume volume = new LabelVolume(
                LabelGrid.of(COLUMNS, 10, 10, labels, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}),
                Map.of(),
                List.of());
        return new Segmentation(volume, new LabelTable(Map.of(1, "lung_L", 2, "lung_R")), "v");
    }

    private static int count(Segmentation s, String name) {
        return s.find(name) > 0 ? s.counts()[s.find(name)] : 0;
    }

    @Test
    void aLobeThatLiesApartIsKeptUnderItsOwnName() {
        Segmentation s = lung(0, 20, 22, 32);
        assertThat(LungPieces.name(s)).singleElement().asString().startsWith("lung_L: a piece of 1 ml lies apart");
        assertThat(count(s, "lung_L")).isEqualTo(20 * 100);
        assertThat(count(s, "lung_L_2")).isEqualTo(10 * 100);
        assertThat(s.labels("lung_L_2")).containsExactly(1);
    }

    @Test
    void aPieceSmallerThanALobeIsNone() {
        Segmentation s = lung(0, 30, 33, 36);
        assertThat(LungPieces.name(s)).isEmpty();
        assertThat(count(s, "lung_L")).isEqualTo(33 * 100);
    }

    @Test
    void aLungOfSpecksAloneIsNone() {
        Segmentation s = lung(0, 20, 30, 40);
        byte right = (byte) s.segment("lung_R");
        s.voxels[25] = right;
        s.voxels[27] = right;
        SegmentationRepair.mend(s);
        assertThat(LungPieces.name(s)).singleElement().asString().startsWith("lung_L: a piece of 1 ml lies apart");
        assertThat(count(s, "lung_R")).isZero();
    }

    /** The right lung has the higher columns here; a piece that touches it is its own only on its side. */
    @Test
    void aPieceAtTheOtherLungIsAPartOfThatOne() {
        Segmentation touching = lungs(30, 40, 0, 12, 25, 30);
        assertThat(LungPieces.name(touching))
                .containsExactly("lung_L: a piece of 1 ml lies at the other lung; it is taken for a part of lung_R");
        assertThat(count(touching, "lung_L")).isEqualTo(12 * 100);
        assertThat(count(touching, "lung_R")).isEqualTo(15 * 100);
        Segmentation apart = lungs(32, 40, 0, 12, 25, 30);
        assertThat(LungPieces.name(apart)).singleElement().asString().contains("lies apart");
        Segmentation near = lungs(20, 40, 0, 12, 13, 20);
        assertThat(LungPieces.name(near)).singleElement().asString().contains("lies apart");
    }
}
