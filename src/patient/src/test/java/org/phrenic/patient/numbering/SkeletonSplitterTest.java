package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/** A cage of ribs and vertebrae under one label, with lungs in it. */
class SkeletonSplitterTest {
    private static final int BONES = 1;
    private static final int RIGHT_LUNG = 2;
    private static final int LEFT_LUNG = 3;
    private static final int SHOULDER_BLADE = 200;

    private final CageVoxels cage = new CageVoxels().withRibs(1);

    /** The cage with a short first rib and a spine, whose labels are the truth, and lungs up to the first rib. */
    SkeletonSplitterTest() {
        cage.shorten(1, 34);
        for (int k = 10; k < 125; k++) {
            cage.ball(44.5, 48, k, 4, CageVoxels.vertebra(12));
        }
        for (int v = 0; v < cage.labels.length; v++) {
            double x = v % CageVoxels.COLUMNS - 44.5;
            double y = (v / CageVoxels.COLUMNS % CageVoxels.ROWS - 30) / 22.0;
            int k = v / CageVoxels.COLUMNS / CageVoxels.ROWS;
            double wall = 36 * Math.sqrt(Math.max(0, 1 - y * y));
            if (cage.labels[v] == 0 && k > 36 && k < 117 && Math.abs(x) > 7 && Math.abs(x) < wall) {
                cage.labels[v] = (byte) (x < 0 ? RIGHT_LUNG : LEFT_LUNG);
            }
        }
    }

    private static boolean isBone(int label) {
        return label > LEFT_LUNG;
    }

    /** The scan of the cage, with the bones that are kept under one label. */
    private Segmentation scan(IntPredicate kept) {
        return scan(kept, 0, CageVoxels.SLICES);
    }

    /** The slices of that scan from one to before another. */
    private Segmentation scan(IntPredicate kept, int from, int to) {
        int row = CageVoxels.COLUMNS * CageVoxels.ROWS;
        byte[] labels = new byte[row * (to - from)];
        for (int v = 0; v < labels.length; v++) {
            int label = cage.labels[row * from + v] & LabelGrid.MAX_BYTE_LABEL;
            labels[v] = (byte) (!isBone(label) ? label : kept.test(label) ? BONES : 0);
        }
        return new Segmentation(
                CageVoxels.volume(labels),
                new LabelTable(Map.of(BONES, LabelTable.ALL_BONES, RIGHT_LUNG, "lung_R", LEFT_LUNG, "lung_L")),
                "scan");
    }

    /** Voxels of each named rib by the number of the true one. */
    private Map<String, Map<Integer, Integer>> truthOfRibs(Segmentation s) {
        Map<String, Map<Integer, Integer>> truth = new TreeMap<>();
        for (int v = 0; v < s.voxels().length; v++) {
            String name = s.segmentAt(v) == 0 ? "" : s.names().get(s.segmentAt(v) - 1);
            if (name.startsWith("rib")) {
                int i = (int) Math.round(s.coordinate(v, 0) / CageVoxels.SPACING_MM);
                int j = (int) Math.round(s.coordinate(v, 1) / CageVoxels.SPACING_MM);
                int k = (int) Math.round(s.coordinate(v, 2) / CageVoxels.SPACING_MM);
                truth.computeIfAbsent(name, n -> new TreeMap<>()).merge(cage.at(i, j, k), 1, Integer::sum);
            }
        }
        return truth;
    }

    private void assertThatRibsAreThoseOfTheCage(Segmentation s) {
        Map<String, Map<Integer, Integer>> truth = truthOfRibs(s);
        assertThat(truth).hasSize(24);
        for (boolean right : new boolean[] {true, false}) {
            for (int number = 1; number <= 12; number++) {
                String name = String.format(Locale.ROOT, "rib_%02d_%s", number, right ? "R" : "L");
                int label = CageVoxels.rib(number, right);
                Map<Integer, Integer> found = truth.get(name);
                assertThat(found).as(name).containsKey(label);
                assertThat(found.keySet()).as(name).isSubsetOf(label, SHOULDER_BLADE);
                // What the spine takes of a rib is the part beside it.
                int whole = count(label);
                assertThat((double) found.get(label) / whole).as(name).isBetween(0.75, 1.0);
            }
        }
    }

    private int count(int label) {
        int count = 0;
        for (byte voxel : cage.labels) {
            count += (voxel & LabelGrid.MAX_BYTE_LABEL) == label ? 1 : 0;
        }
        return count;
    }

    /** It is as high as the apex of these lungs, but as long as the third. */
    @Test
    void aSecondRibIsNoFirst() {
        for (int v = CageVoxels.COLUMNS * CageVoxels.ROWS * 109; v < cage.labels.length; v++) {
            cage.labels[v] = isBone(cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) ? cage.labels[v] : 0;
        }
        int right = CageVoxels.rib(1, true);
        int left = CageVoxels.rib(1, false);
        assertThat(SkeletonSplitter.split(scan(label -> label != right && label != left)))
                .hasValueSatisfying(note -> assertThat(note).contains("ribs are not told apart"));
    }

    @Test
    void ribsAreCountedFromTheFirst() {
        Segmentation s = scan(label -> true);
        assertThat(SkeletonSplitter.split(s))
                .contains("bones under one label: 24 ribs are counted from the first, the spine is separated");
        assertThatRibsAreThoseOfTheCage(s);
        assertThat(s.counts()[s.find(LabelTable.SPINE)]).isGreaterThan(1000);
    }

    /** A plate behind the left ribs touches four of them: with them it is larger than any rib. */
    @Test
    void ribsThatTouchAShoulderBladeAreSeparatedFromIt() {
        for (int k = 62; k < 96; k++) {
            for (int i = 68; i < 88; i++) {
                cage.ball(i, 57.5, k, 1.4, SHOULDER_BLADE);
            }
        }
        for (int number = 4; number <= 7; number++) {
            cage.ball(70, 53, 124 - 8 * number - 3, 3.8, SHOULDER_BLADE);
        }
        Segmentation s = scan(label -> true);
        assertThat(SkeletonSplitter.split(s))
                .hasValueSatisfying(note -> assertThat(note).contains("24 ribs"));
        assertThatRibsAreThoseOfTheCage(s);
    }

    /** Without a rib in between the numbers of those below are not known: nothing is changed. */
    @Test
    void ribsWithAGapAreNotCounted() {
        Segmentation s = scan(label -> label != CageVoxels.rib(6, true));
        byte[] before = s.voxels().clone();
        assertThat(SkeletonSplitter.split(s))
                .hasValueSatisfying(note -> assertThat(note).contains("ribs are not told apart"));
        assertThat(s.voxels()).isEqualTo(before);
    }

    /** A scan of the abdomen ends at slice 78, below the heads of ribs 1 to 5: of ribs 4 and 5 it shows the fronts. */
    @Test
    void ribsOfAnAbdomenAreCountedFromTheLast() {
        cage.shorten(11, 20);
        cage.shorten(12, 43);
        Segmentation s = scan(label -> true, 0, 78);
        assertThat(SkeletonSplitter.split(s))
                .hasValueSatisfying(note -> assertThat(note).contains("ribs are told apart, the spine is separated"));
        BoneNumbering.numberRibs(s);
        Map<String, Map<Integer, Integer>> truth = truthOfRibs(s);
        assertThat(truth).hasSizeBetween(16, 18).containsKeys("rib_05_R", "rib_05_L", "rib_12_R", "rib_12_L");
        truth.forEach((name, labels) -> {
            int number = Integer.parseInt(name.substring(4, 6));
            assertThat(labels.keySet()).as(name).containsExactly(CageVoxels.rib(number, name.endsWith("R")));
        });
    }

    /**
     * A slab that ends at slice 78 and begins at 20, in the fronts of ribs 11 and 12, does not tell which are the last.
     */
    @Test
    void ribsOfASlabAreNotCounted() {
        Segmentation s = scan(label -> true, 20, 78);
        assertThat(SkeletonSplitter.split(s))
                .hasValueSatisfying(note -> assertThat(note).contains("ribs are not told apart"));
    }

    /** Of a scan that begins below the first rib the highest one is not the first. */
    @Test
    void ribsBelowTheApexOfTheLungAreNotCounted() {
        Segmentation s = scan(label -> label != CageVoxels.rib(1, true) && label != CageVoxels.rib(1, false));
        assertThat(SkeletonSplitter.split(s))
                .hasValueSatisfying(note -> assertThat(note).contains("ribs are not told apart"));
    }

    @Test
    void ribsWithLabelsOfTheirOwnAreLeftAlone() {
        assertThat(SkeletonSplitter.split(new CageVoxels().withRibs(1).segmentation(CageVoxels.table(false))))
                .isEqualTo(Optional.empty());
    }
}
