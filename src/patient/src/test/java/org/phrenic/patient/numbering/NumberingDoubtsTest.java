package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.MeshingSettings;
import org.phrenic.patient.ScanImport;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;

/** A cage in which a vertebra has two labels or none, or the ribs of one side have those of their neighbours. */
class NumberingDoubtsTest {
    /** Column of the median plane. */
    private static final double MIDDLE = 44.5;

    private static final int SLICE = CageVoxels.COLUMNS * CageVoxels.ROWS;
    private static final int T1 = CageVoxels.vertebra(1);
    private static final int T12 = CageVoxels.vertebra(12);

    private static CageVoxels cage() {
        return CageVoxels.withFloatingRibs().withVertebrae(1);
    }

    private static Segmentation scan(CageVoxels cage, IntUnaryOperator relabel) {
        return scan(cage, 0, CageVoxels.SLICES, relabel);
    }

    private static Segmentation scan(CageVoxels cage, int first, int last, IntUnaryOperator relabel) {
        byte[] labels = Arrays.copyOfRange(cage.labels, SLICE * first, SLICE * last);
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) relabel.applyAsInt(labels[v] & LabelGrid.MAX_BYTE_LABEL);
        }
        return new Segmentation(CageVoxels.volume(labels), CageVoxels.table(false), "scan");
    }

    /** What an import says on numbers that it leaves. */
    private static List<String> doubts(Segmentation s) {
        byte[] before = s.voxels().clone();
        List<String> notes = NumberingDoubts.find(s);
        assertThat(s.voxels()).isEqualTo(before);
        return notes;
    }

    private static String vertebra(int number) {
        return String.format(Locale.ROOT, "vertebra_T%02d", number);
    }

    private static boolean isRib(int label, boolean right) {
        return label >= CageVoxels.rib(1, right) && label <= CageVoxels.rib(12, right);
    }

    /** Labels of the ribs of a side so many numbers from a number on; those without a number are left out. */
    private static IntUnaryOperator ribsMoved(boolean right, int by, int from, int without) {
        return label -> {
            int number = label - CageVoxels.rib(1, right) + 1;
            if (!isRib(label, right) || number < from) {
                return label;
            }
            return number == without || !isRib(label + by, right) ? 0 : label + by;
        };
    }

    /** Vertebrae from a number on carry that of the next one beyond, so that their own is left out. */
    @Test
    void aNumberThatTheSpineSkipsIsNoted() {
        for (int number = 4; number < 11; number++) {
            int first = CageVoxels.vertebra(number);
            IntUnaryOperator below = label -> label < T12 || label > first ? label : label == T12 ? 0 : label - 1;
            assertThat(doubts(scan(cage(), below)))
                    .containsExactly(vertebra(number) + " is missing between two vertebrae that follow each other, and"
                            + " the ribs below lie beside vertebrae one number higher than theirs: check whether the"
                            + " numbers of the vertebrae skip one");
            IntUnaryOperator above = label -> label < first || label > T1 ? label : label == T1 ? 0 : label + 1;
            assertThat(doubts(scan(cage(), above)))
                    .singleElement()
                    .asString()
                    .startsWith(vertebra(number) + " is missing")
                    .contains("the ribs above lie beside vertebrae one number lower");
            assertThat(doubts(scan(cage(), label -> label == first ? 0 : label)))
                    .isEmpty();
        }
    }

    /** One vertebra under its label and that of a neighbour, those beyond which are one off; without beyond these. */
    private static Segmentation split(int number, boolean upper) {
        CageVoxels cage = cage();
        for (int v = 0; v < cage.labels.length; v++) {
            boolean beyond = v / SLICE > CageVoxels.vertebraSlice(number) == upper;
            if (cage.labels[v] >= T12 && cage.labels[v] <= T1 && beyond) {
                int moved = cage.labels[v] + (upper ? 1 : -1);
                cage.labels[v] = (byte) (moved > T1 || moved < T12 ? 0 : moved);
            }
        }
        return scan(cage, label -> label);
    }

    @Test
    void aVertebraUnderTwoLabelsIsNoted() {
        for (int number = 4; number < 9; number++) {
            assertThat(doubts(split(number, true)))
                    .containsExactly(vertebra(number - 1) + " and " + vertebra(number) + " together are as tall as one"
                            + " vertebra, and the ribs above lie beside vertebrae one number lower than theirs: check"
                            + " whether the two labels hold one vertebra");
            assertThat(doubts(split(number, false)))
                    .singleElement()
                    .asString()
                    .startsWith(vertebra(number) + " and " + vertebra(number + 1) + " together")
                    .contains("the ribs below lie beside vertebrae one number higher");
        }
    }

    /** The lower of two vertebrae under the label of the upper one, the others with their numbers. */
    @Test
    void twoVertebraeUnderOneLabelAmongRightNumbersAreNoted() {
        for (int number = 2; number < 11; number++) {
            int next = CageVoxels.vertebra(number + 1);
            Segmentation s = scan(cage(), label -> label == next ? label + 1 : label);
            assertThat(BoneNumbering.numberRibs(s)).isEmpty();
            assertThat(doubts(s))
                    .singleElement()
                    .asString()
                    .startsWith(vertebra(number) + " is ")
                    .endsWith(" times as tall as its neighbours: check whether its label holds two vertebrae");
        }
    }

    @Test
    void anImportNotesDoubts() {
        CageVoxels cage = cage();
        for (int v = 0; v < cage.labels.length; v++) {
            cage.labels[v] += (byte) (cage.labels[v] == CageVoxels.vertebra(8) ? 1 : 0);
        }
        assertThat(new ScanImport(cage.volume(), "scan", MeshingSettings.PAPER, Optional.empty(), (n, of, what) -> {})
                        .run(CageVoxels.table(false), "body")
                        .notes())
                .filteredOn(note -> note.startsWith(vertebra(7) + " is "))
                .hasSize(1);
    }

    @Test
    void twoVertebraeThatAreAlreadyPartedAreNotNoted() {
        int kept = CageVoxels.vertebra(7);
        Segmentation s = scan(cage(), label -> label > kept && label <= T1 ? label - 1 : label);
        assertThat(doubts(s)).hasSize(1);
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().contains("parted");
        assertThat(doubts(s)).isEmpty();
    }

    @Test
    void ribsOfASideThatAreOneOffThoseOfTheOtherAreNoted() {
        assertThat(doubts(scan(cage(), ribsMoved(true, 1, 1, 12))))
                .containsExactly("right ribs 2 to 12 lie one vertebra above those of the left side, which fit the"
                        + " vertebrae: rib_03_R beside rib_02_L; check the numbers of the right ribs");
        assertThat(doubts(scan(cage(), ribsMoved(false, -1, 1, 1))))
                .containsExactly("left ribs 1 to 11 lie one vertebra below those of the right side, which fit the"
                        + " vertebrae: rib_01_L beside rib_02_R; check the numbers of the left ribs");
    }

    @Test
    void ribsOfASideCountedOnBeyondOneWithoutALabelAreNoted() {
        assertThat(doubts(scan(cage(), ribsMoved(true, -1, 6, 6))))
                .singleElement()
                .asString()
                .startsWith("right ribs 6 to 1")
                .contains("lie one vertebra below those of the left side");
        assertThat(doubts(scan(cage(), ribsMoved(true, 0, 6, 6)))).isEmpty();
        assertThat(doubts(scan(cage(), ribsMoved(true, -1, 9, 9)))).isEmpty();
    }

    /** The cage, each column of which is raised by so many of its steps to the left in some slices. */
    private static CageVoxels leaning(double rise, int first, int last) {
        CageVoxels cage = cage();
        byte[] upright = cage.labels.clone();
        for (int v = 0; v < upright.length; v++) {
            int k = v / SLICE;
            double share = Math.max(0, Math.min(1, Math.min(k - first, last - k) / 16.0));
            long from = k - Math.round(rise * share * (v % CageVoxels.COLUMNS - MIDDLE));
            cage.labels[v] = from < 0 || from >= CageVoxels.SLICES ? 0 : upright[(int) (v + (from - k) * SLICE)];
        }
        return cage;
    }

    private static void clear(CageVoxels cage, Set<Integer> gone) {
        for (int v = 0; v < cage.labels.length; v++) {
            cage.labels[v] = gone.contains(cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) ? 0 : cage.labels[v];
        }
    }

    /** As where a curve of the spine tilts some vertebrae, or the trunk leans; ribs of one side or both end. */
    @Test
    void rightNumbersOfALeaningSpineAreNotNoted() {
        for (double rise : new double[] {-0.5, -0.3, -0.15, 0.15, 0.3, 0.5}) {
            for (int[] slices : new int[][] {{-20, 150}, {19, 83}, {50, 150}}) {
                for (int last : new int[] {8, 10, 12}) {
                    CageVoxels cage = leaning(rise, slices[0], slices[1]);
                    for (int number = last + 1; number <= 12; number++) {
                        clear(cage, Set.of(CageVoxels.rib(number, true)));
                    }
                    assertThat(doubts(scan(cage, label -> label))).isEmpty();
                }
            }
        }
    }

    @Test
    void ribsOfASideOfALeaningSpineThatAreOneOffAreNoted() {
        for (double rise : new double[] {-0.3, 0.3}) {
            assertThat(doubts(scan(leaning(rise, -20, 150), ribsMoved(true, 1, 1, 12))))
                    .singleElement()
                    .asString()
                    .contains("right ribs", "lie one vertebra above");
        }
    }

    /**
     * Ribs of a cage that end so far from the median plane, of one side with a further fall, mm for each mm, beyond the
     * transverse processes, as on the convex side of a curve.
     */
    private static CageVoxels steep(CageVoxels cage, double beginMm, double fall, boolean right) {
        byte[] before = cage.labels.clone();
        for (int v = 0; v < before.length; v++) {
            int label = before[v] & LabelGrid.MAX_BYTE_LABEL;
            double mm = CageVoxels.SPACING_MM * (v % CageVoxels.COLUMNS - MIDDLE);
            double beyond = (mm < 0) == right ? Math.min(30, Math.max(0, Math.abs(mm) - 30)) : 0;
            int from = v + SLICE * (int) Math.round(fall * beyond / CageVoxels.SPACING_MM);
            int rib = from < before.length ? before[from] & LabelGrid.MAX_BYTE_LABEL : 0;
            if (label == 0 || isRib(label, true) || isRib(label, false)) {
                boolean shown = Math.abs(mm) >= beginMm && (isRib(rib, true) || isRib(rib, false));
                cage.labels[v] = (byte) (shown ? rib : 0);
            }
        }
        return cage;
    }

    @Test
    void rightNumbersOfSteepRibsThatEndFarFromTheSpineAreNotNoted() {
        int seventh = CageVoxels.vertebra(7);
        for (double begin : new double[] {0, 36, 45, 51}) {
            for (double fall : new double[] {0.4, 1.0}) {
                for (boolean right : new boolean[] {true, false}) {
                    CageVoxels cage = steep(cage(), begin, fall, right);
                    clear(cage, Set.of(CageVoxels.rib(11, right), CageVoxels.rib(12, right)));
                    assertThat(doubts(scan(cage, label -> label)))
                            .as("from %s mm on, fall %s", begin, fall)
                            .isEmpty();
                    CageVoxels bent = steep(kyphotic(8, Set.of()), begin, fall, right);
                    assertThat(doubts(scan(bent, label -> label == seventh ? 0 : label)))
                            .as("bent, from %s mm on, fall %s", begin, fall)
                            .isEmpty();
                }
            }
        }
    }

    /** Each cut shows another part of the cage. */
    @Test
    void rightNumbersOfAShortFieldOfViewAreNotNoted() {
        for (int first = 0; first < 100; first += 10) {
            for (int last = first + 30; last <= CageVoxels.SLICES; last += 20) {
                assertThat(doubts(scan(cage(), first, last, label -> label)))
                        .as("slices %d to %d", first, last)
                        .isEmpty();
            }
        }
    }

    /**
     * A bent spine: bodies before the ends of the ribs, those of T1 to T6 lower by some slices than the arches that the
     * ribs meet; bodies of some numbers are half as tall.
     */
    private static CageVoxels kyphotic(int lower, Set<Integer> low) {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        for (int number = 1; number <= 12; number++) {
            int slice = CageVoxels.vertebraSlice(number);
            int body = low.contains(number) ? 66 - 5 * (number - 6) : number < 7 ? slice - lower : slice;
            for (int above = low.contains(number) ? 0 : -2; above <= (low.contains(number) ? 1 : 2); above++) {
                cage.ball(MIDDLE, 40, body + above, 1.8, CageVoxels.vertebra(number));
            }
            cage.ball(MIDDLE, 54, slice, 1.8, CageVoxels.vertebra(number));
        }
        return cage;
    }

    @Test
    void collapsedVertebraeOfABentSpineAreNotNoted() {
        Segmentation pair = scan(kyphotic(9, Set.of(7, 8)), label -> label);
        assertThat(new VertebraHeights(pair).areHalves(7)).isTrue();
        assertThat(doubts(pair)).isEmpty();
        int seventh = CageVoxels.vertebra(7);
        Segmentation without = scan(kyphotic(8, Set.of()), label -> label == seventh ? 0 : label);
        assertThat(new VertebraHeights(without).isSkipped(7)).isTrue();
        assertThat(doubts(without)).isEmpty();
    }

    /** A cage whose vertebrae have so many slices, each like the middle one. */
    private static CageVoxels lowered(IntUnaryOperator slices) {
        CageVoxels whole = cage();
        CageVoxels cage = cage();
        for (int number = 1; number <= 12; number++) {
            int label = CageVoxels.vertebra(number);
            int middle = CageVoxels.vertebraSlice(number);
            int first = middle - slices.applyAsInt(number) / 2;
            for (int v = 0; v < cage.labels.length; v++) {
                int slice = v / SLICE;
                boolean inside = slice >= first && slice < first + slices.applyAsInt(number);
                if (inside && whole.labels[middle * SLICE + v % SLICE] == label) {
                    cage.labels[v] = (byte) label;
                } else if (cage.labels[v] == label) {
                    cage.labels[v] = 0;
                }
            }
        }
        return cage;
    }

    /** Low vertebrae about a whole one, and some that follow each other, in a straight spine. */
    @Test
    void lowVertebraeAmongRightNumbersAreNotNoted() {
        for (Set<Integer> low :
                List.of(Set.of(7, 9), Set.of(7, 8), Set.of(6), Set.of(5, 6, 7, 8), Set.of(6, 8, 9), Set.of(10, 12))) {
            CageVoxels cage = lowered(number -> low.contains(number) ? 2 : 5);
            assertThat(doubts(scan(cage, label -> label))).as("low %s", low).isEmpty();
        }
    }

    /** In thick slices a vertebra has two or three, as it lies. */
    @Test
    void aVertebraOfThreeSlicesAmongThoseOfTwoIsNotNoted() {
        CageVoxels cage = lowered(number -> number == 7 ? 3 : 2);
        assertThat(doubts(scan(cage, label -> label))).isEmpty();
    }
}
