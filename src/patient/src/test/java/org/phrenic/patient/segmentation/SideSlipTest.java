package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.TreeMap;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;

/** A cage whose ribs of one side carry the labels of their neighbours. */
class SideSlipTest {
    /** Ribs of a side by their true number; 0 for none. */
    private static Segmentation scan(boolean right, IntUnaryOperator number) {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        int first = CageVoxels.rib(1, right);
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            if (label >= first && label < first + RibNumbering.RIBS) {
                int now = number.applyAsInt(label - first + 1);
                cage.labels[v] = (byte) (now == 0 ? 0 : CageVoxels.rib(now, right));
            }
        }
        return cage.segmentation(CageVoxels.table(false));
    }

    private static TreeMap<String, Integer> counts(Segmentation s) {
        TreeMap<String, Integer> counts = new TreeMap<>();
        int[] all = s.counts();
        s.names().stream().filter(name -> all[s.find(name)] > 0).forEach(name -> counts.put(name, all[s.find(name)]));
        return counts;
    }

    @Test
    void ribsOfOneSideThatAreOneOffAreNumberedAnew() {
        TreeMap<String, Integer> high = counts(scan(true, number -> number == 12 ? 0 : number));
        Segmentation s = scan(true, number -> number == 12 ? 0 : number + 1);
        assertThat(SegmentationRepair.numberRibs(s))
                .containsExactly("right ribs 2 to 12 begin at the vertebrae one above their numbers, left ones at"
                        + " theirs: they are numbered 1 to 11");
        assertThat(counts(s)).isEqualTo(high);
        assertThat(s.labels("rib_01_R")).containsExactly(CageVoxels.rib(2, true));
        TreeMap<String, Integer> low = counts(scan(false, number -> number == 1 ? 0 : number));
        s = scan(false, number -> number - 1);
        assertThat(SegmentationRepair.numberRibs(s))
                .containsExactly("left ribs 1 to 11 begin at the vertebrae one below their numbers, right ones at"
                        + " theirs: they are numbered 2 to 12");
        assertThat(counts(s)).isEqualTo(low);
    }

    @Test
    void ribsCountedOnBeyondOneWithoutALabelAreNumberedAnew() {
        TreeMap<String, Integer> truth = counts(scan(true, number -> number == 8 ? 0 : number));
        Segmentation above = scan(true, number -> number == 8 ? 0 : number < 8 ? number + 1 : number);
        assertThat(SegmentationRepair.numberRibs(above))
                .singleElement()
                .asString()
                .startsWith("right ribs 2 to 8 begin")
                .endsWith("numbered 1 to 7");
        assertThat(counts(above)).isEqualTo(truth);
        Segmentation below = scan(true, number -> number == 8 ? 0 : number > 8 ? number - 1 : number);
        assertThat(SegmentationRepair.numberRibs(below))
                .singleElement()
                .asString()
                .startsWith("right ribs 8 to 11 begin")
                .endsWith("numbered 9 to 12");
        assertThat(counts(below)).isEqualTo(truth);
    }

    @Test
    void aRibWithoutALabelLeavesTheOthersTheirNumbers() {
        Segmentation s = scan(true, number -> number == 8 ? 0 : number);
        TreeMap<String, Integer> before = counts(s);
        assertThat(SegmentationRepair.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(before);
    }
}
