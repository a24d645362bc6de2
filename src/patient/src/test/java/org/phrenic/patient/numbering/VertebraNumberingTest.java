package org.phrenic.patient.numbering;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.CageVoxels;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.Specks;

/** A cage whose ribs or vertebrae carry the label of their neighbour. */
class VertebraNumberingTest {
    /** The slices below end with the heads of rib 8. */
    private static final int ABDOMEN = 58;
    /** The slices from here on show the heads of ribs 1 to 9 and all of ribs 1 to 7. */
    private static final int CHEST = 48;

    /** Column of the median plane. */
    private static final double MIDDLE = 44.5;

    private static final int FIRST_LEFT = CageVoxels.rib(1, false);
    private static final int LAST_RIGHT = CageVoxels.rib(12, true);
    private static final int T1 = CageVoxels.vertebra(1);
    private static final int T12 = CageVoxels.vertebra(12);

    private static final int RIGHT_LUNG = 2;
    private static final int LEFT_LUNG = 3;
    private static final int SACRAL = 4;
    private static final int CARTILAGE = 5;
    private static final int OTHER = 6;

    private static CageVoxels cage() {
        CageVoxels cage = CageVoxels.withFloatingRibs();
        return cage.withVertebrae(1);
    }

    private static Segmentation scan(CageVoxels cage, int slices, IntUnaryOperator relabel) {
        byte[] labels = Arrays.copyOf(cage.labels, CageVoxels.COLUMNS * CageVoxels.ROWS * slices);
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) relabel.applyAsInt(labels[v] & LabelGrid.MAX_BYTE_LABEL);
        }
        return new Segmentation(CageVoxels.volume(labels), CageVoxels.table(false), "scan");
    }

    /** Labels of vertebrae one higher in the spine (-1) or one lower; without a label beyond the thoracic ones. */
    private static IntUnaryOperator vertebraeMoved(int down) {
        return label -> {
            int moved = label - down;
            return label < T12 || label > T1 ? label : moved < T12 || moved > T1 ? 0 : moved;
        };
    }

    private static IntUnaryOperator ribsMovedDown() {
        return label -> {
            boolean last = label == CageVoxels.rib(12, false) || label == LAST_RIGHT;
            return label < FIRST_LEFT || label > LAST_RIGHT ? label : last ? 0 : label + 1;
        };
    }

    /** Voxels of each structure; of one whose true voxels have no label there are none. */
    private static TreeMap<String, Integer> counts(Segmentation s) {
        TreeMap<String, Integer> counts = new TreeMap<>();
        int[] all = s.counts();
        for (String name : s.names()) {
            if (all[s.find(name)] > 0) {
                counts.put(name, all[s.find(name)]);
            }
        }
        return counts;
    }

    private static TreeMap<String, Integer> truth(int slices, String... without) {
        TreeMap<String, Integer> truth = counts(scan(cage(), slices, label -> label));
        truth.keySet().removeAll(List.of(without));
        return truth;
    }

    /**
     * The cage with short first ribs and lungs up to these, with eleven pairs of ribs and vertebrae one number high.
     */
    private static Segmentation fromBelow(int firstRow, int apex) {
        return fromBelow(firstRow, apex, "liver");
    }

    /** The same with another structure above the spine. */
    private static Segmentation fromBelow(int firstRow, int apex, String other) {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        cage.shorten(1, firstRow);
        for (int k = 40; k < apex; k++) {
            cage.ball(MIDDLE - 20, 30, k, 8, RIGHT_LUNG);
            cage.ball(MIDDLE + 20, 30, k, 8, LEFT_LUNG);
        }
        cage.ball(MIDDLE, 50, 10, 3, SACRAL);
        cage.ball(MIDDLE - 10, 4, 90, 2, CARTILAGE);
        cage.ball(MIDDLE, 50, 124, 3, OTHER);
        byte[] labels = new byte[cage.labels.length];
        for (int v = 0; v < labels.length; v++) {
            int label = ribsMovedDown().applyAsInt(cage.labels[v] & LabelGrid.MAX_BYTE_LABEL);
            labels[v] = (byte) vertebraeMoved(1).applyAsInt(label);
        }
        Map<Integer, String> table = new TreeMap<>(CageVoxels.table(false).structures());
        table.put(RIGHT_LUNG, "lung_R");
        table.put(LEFT_LUNG, "lung_L");
        table.put(SACRAL, "vertebra_S1");
        table.put(CARTILAGE, "costal_cartilage_03_R");
        table.put(OTHER, other);
        return new Segmentation(CageVoxels.volume(labels), new LabelTable(table), "scan");
    }

    /** Adds a few voxels of structures in the front of the uppermost slice. */
    private static Segmentation withSpecks(Segmentation s, String... structures) {
        int at = s.voxels().length - s.grid().columns() * s.grid().rows();
        for (String structure : structures) {
            Arrays.fill(s.voxels(), at, at + 5, (byte) s.find(structure));
            at += 7;
        }
        return s;
    }

    /** An abdominal scan with vertebrae and organs labelled: no first vertebra, no neck and no rib. */
    @Test
    void vertebraeOfAScanWithoutRibsKeepTheirNumbers() {
        Segmentation s = scan(cage(), ABDOMEN, label -> label < FIRST_LEFT ? label : 0);
        TreeMap<String, Integer> before = counts(s);
        assertThat(before).containsKey("vertebra_T12").doesNotContainKey("vertebra_T01");
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(before);
    }

    @Test
    void firstRibsWithTheNumberTwoAreNumberedAnewWithTheirSpine() {
        Segmentation s = fromBelow(34, 108);
        int second = s.counts()[s.find("rib_03_R")];
        assertThat(BoneNumbering.numberRibs(s))
                .containsExactly("the highest ribs have the number 2, but are as short as the first ones and end at the"
                        + " top of the lungs: ribs and vertebrae are numbered one lower");
        Map<String, Integer> found = counts(s);
        assertThat(found)
                .containsKeys("rib_01_L", "rib_11_L", "rib_11_R", "vertebra_T01", "vertebra_T11", "vertebra_L05")
                .containsKey("costal_cartilage_02_R")
                .doesNotContainKeys("rib_12_L", "rib_12_R", "vertebra_T12")
                .containsEntry("rib_02_R", second);
        assertThat(s.labels("rib_01_R")).containsExactly(CageVoxels.rib(2, true));
    }

    @Test
    void aSpineBelowALabelledNeckKeepsItsNumbers() {
        for (String neck : List.of("vertebra_C7", "disc_C7_T1", "vertebra_C1")) {
            Segmentation s = fromBelow(34, 108, neck);
            assertThat(BoneNumbering.numberRibs(s)).isEmpty();
            assertThat(counts(s)).containsKeys(neck, "vertebra_T02", "rib_02_R");
        }
    }

    @Test
    void cartilagesOfWhichThereIsAFirstKeepTheirNumbers() {
        Segmentation s = fromBelow(34, 108, "costal_cartilage_01_R");
        assertThat(BoneNumbering.numberRibs(s)).hasSize(1);
        assertThat(counts(s))
                .containsKeys("rib_01_R", "costal_cartilage_01_R", "costal_cartilage_03_R")
                .doesNotContainKey("costal_cartilage_02_R");
    }

    /** They are as long as the third, or lie below the apex of the lungs. */
    @Test
    void secondRibsKeepTheirNumber() {
        assertThat(BoneNumbering.numberRibs(fromBelow(0, 108))).isEmpty();
        assertThat(BoneNumbering.numberRibs(fromBelow(34, 120))).isEmpty();
    }

    /** Ribs 1 to 11, moved down by one, with one voxel under the name of rib 1: the ribs are wrong, not the spine. */
    @Test
    void aSpeckIsNoRibByWhichTheSpineIsNumbered() {
        IntUnaryOperator moved = ribsMovedDown();
        boolean[] speck = {false};
        CageVoxels cage = cage();
        Segmentation s = scan(cage, CageVoxels.SLICES, label -> {
            int now = moved.applyAsInt(label);
            boolean first = now == CageVoxels.rib(2, true) && !speck[0];
            speck[0] |= first;
            return first ? CageVoxels.rib(1, true) : now;
        });
        assertThat(VertebraNumbering.check(s)).get().asString().startsWith("ribs, ");
    }

    @Test
    void firstRibsAreToldByThemselvesAndLungsWithoutSpecks() {
        for (String structure : List.of("rib_02_R", "rib_03_L", "lung_R", "lung_L")) {
            assertThat(BoneNumbering.numberRibs(withSpecks(fromBelow(34, 108), structure)))
                    .as(structure)
                    .singleElement()
                    .asString()
                    .startsWith("the highest ribs have the number 2");
        }
    }

    @Test
    void aTwelfthRibIsToldWithoutSpecksOfItAndOfTheOneAbove() {
        Segmentation vertebrae = withSpecks(scan(cage(), ABDOMEN, vertebraeMoved(-1)), "rib_12_R", "rib_12_L");
        assertThat(BoneNumbering.numberRibs(vertebrae))
                .singleElement()
                .asString()
                .startsWith("the vertebrae lie one");
        Segmentation ribs = withSpecks(scan(cage(), ABDOMEN, ribsMovedDown()), "rib_11_R");
        assertThat(BoneNumbering.numberRibs(ribs)).singleElement().asString().startsWith("ribs, whose vertebrae");
    }

    @Test
    void aWholeScanCutsNoRibsOffAboveWhereASpeckOfOneReachesItsEnd() {
        Segmentation s = withSpecks(scan(cage(), 119, label -> label), "rib_07_R");
        assertThat(new RibDeviations(s, Specks.none()).areCutAbove()).isTrue();
        assertThat(new RibDeviations(s, Specks.ofBones(s)).areCutAbove()).isFalse();
    }

    @Test
    void twoVertebraeUnderOneLabelAreToldWithoutSpecks() {
        Segmentation right = withSpecks(scan(cage(), CageVoxels.SLICES, label -> label), "vertebra_T05");
        assertThat(new VertebraHeights(right, Specks.none()).isDouble(5)).isTrue();
        assertThat(new VertebraHeights(right).isDouble(5)).isFalse();
        Segmentation two = withSpecks(scan(cage(), CageVoxels.SLICES, doubled(5, true)), "vertebra_T06");
        assertThat(BoneNumbering.numberRibs(two)).singleElement().asString().startsWith("vertebra_T05 is as tall as");
    }

    /**
     * Three voxels of T7 in front, in a scan of the abdomen that does not show it, or in a whole one beside the rest.
     */
    @Test
    void aSlipOfTheSpineIsToldWithoutSpecksOfAVertebra() {
        for (int slices : new int[] {60, CageVoxels.SLICES}) {
            for (int down = -1; down <= 1; down++) {
                List<String> notes = BoneNumbering.numberRibs(scan(cage(), slices, vertebraeMoved(down)));
                assertThat(notes).hasSize(Math.abs(down));
                for (int slice : new int[] {5, 20, 30}) {
                    CageVoxels cage = cage();
                    for (int row = 5; row < 8; row++) {
                        int v = 5 + CageVoxels.COLUMNS * (row + CageVoxels.ROWS * slice);
                        cage.labels[v] = (byte) CageVoxels.vertebra(7 - down);
                    }
                    Segmentation s = scan(cage, slices, vertebraeMoved(down));
                    assertThat(BoneNumbering.numberRibs(s))
                            .as("%d slices, moved by %d, specks in slice %d", slices, down, slice)
                            .isEqualTo(notes);
                }
            }
        }
    }

    @Test
    void aSpeckOfAFirstRibOrOfTheNeckDoesNotHideThatRibsBeginWithTheSecond() {
        for (String name : List.of("rib_01_R", "vertebra_C7")) {
            Segmentation s = fromBelow(34, 108, name);
            int segment = s.find(name);
            int kept = 0;
            for (int v = 0; v < s.voxels().length; v++) {
                if (s.segmentAt(v) == segment && ++kept > 1) {
                    s.voxels()[v] = 0;
                }
            }
            assertThat(BoneNumbering.numberRibs(s))
                    .as(name)
                    .singleElement()
                    .asString()
                    .startsWith("the highest ribs have the number 2");
        }
    }

    /** A scan that begins in the upper edge of T8: its voxels there are a vertebra, but not so few elsewhere. */
    @Test
    void whatAnEndOfTheScanLeavesOfAVertebraIsNoSpeck() {
        CageVoxels cage = cage();
        cage.ball(20, 30, 10, 0.5, CageVoxels.vertebra(7));
        Segmentation s = scan(cage, CageVoxels.vertebraSlice(8) - 2, label -> label);
        assertThat(s.counts()[s.find("vertebra_T08")]).isBetween(1, 20);
        Specks specks = Specks.ofBones(s);
        for (int v = 0; v < s.voxels().length; v++) {
            assertThat(specks.contain(v)).isEqualTo(s.segmentAt(v) == s.find("vertebra_T07"));
        }
    }

    /** A tall vertebra between low ones, with the ribs above it one off on the right alone. */
    @Test
    void ribsThatDeviateUnlikeEachOtherTellNothingOfATallVertebra() {
        CageVoxels cage = withLow(4, 6);
        Segmentation s = scan(cage, CageVoxels.SLICES, label -> {
            boolean moves = label > CageVoxels.rib(2, true) && label <= CageVoxels.rib(5, true);
            return label == CageVoxels.rib(2, true) ? 0 : moves ? label - 1 : label;
        });
        assertThat(new VertebraHeights(s).isDouble(5)).isTrue();
        assertThat(VertebraNumbering.check(s)).isEmpty();
    }

    @Test
    void numbersThatFitAreLeftAlone() {
        Segmentation s = scan(cage(), CageVoxels.SLICES, label -> label);
        assertThat(VertebraNumbering.check(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(truth(CageVoxels.SLICES));
    }

    @Test
    void vertebraeOneOffTwelvePairsOfRibsAreNumberedAnew() {
        Segmentation below = scan(cage(), CageVoxels.SLICES, vertebraeMoved(-1));
        assertThat(BoneNumbering.numberRibs(below)).singleElement().satisfies(note -> assertThat(note)
                .contains("one below the ribs", "vertebra_T12 is vertebra_L01 now"));
        assertThat(counts(below)).isEqualTo(truth(CageVoxels.SLICES, "vertebra_T01"));
        assertThat(below.labels("vertebra_T12")).containsExactly(CageVoxels.vertebra(11));
        Segmentation above = scan(cage(), CageVoxels.SLICES, vertebraeMoved(1));
        assertThat(BoneNumbering.numberRibs(above)).singleElement().satisfies(note -> assertThat(note)
                .contains("one above the ribs", "vertebra_L01 is vertebra_T12 now"));
        assertThat(counts(above)).isEqualTo(truth(CageVoxels.SLICES, "vertebra_T12"));
    }

    /** Two vertebrae under the label of the lower one, those above one too low, or of the upper one and the mirror. */
    private static IntUnaryOperator doubled(int number, boolean above) {
        int kept = CageVoxels.vertebra(number);
        return label -> {
            boolean isThoracic = label >= T12 && label <= T1;
            boolean moves = isThoracic && (above ? label > kept : label < kept);
            return moves ? label + (above ? -1 : 1) : label;
        };
    }

    @Test
    void twoVertebraeUnderOneLabelArePartedAndThoseBeyondThemNumberedAnew() {
        for (int number = 4; number < 11; number++) {
            Segmentation lower = scan(cage(), CageVoxels.SLICES, doubled(number, true));
            String name = String.format(Locale.ROOT, "vertebra_T%02d", number);
            String before = String.format(Locale.ROOT, "vertebra_T%02d", number - 1);
            assertThat(BoneNumbering.numberRibs(lower))
                    .containsExactly(name + " is as tall as two vertebrae, and those above it lie one above the ribs of"
                            + " their numbers: they are numbered anew, and it is parted at half its height into " + name
                            + " and " + before);
            assertThat(counts(lower)).isEqualTo(truth(CageVoxels.SLICES));
            assertThat(lower.labels(before)).containsExactly(CageVoxels.vertebra(number));
            Segmentation upper = scan(cage(), CageVoxels.SLICES, doubled(number - 1, false));
            assertThat(BoneNumbering.numberRibs(upper))
                    .singleElement()
                    .asString()
                    .startsWith(before + " is as tall as two vertebrae, and those below it lie one below")
                    .endsWith("into " + before + " and " + name);
            assertThat(counts(upper)).isEqualTo(truth(CageVoxels.SLICES));
        }
    }

    /** The cage with two vertebrae of two slices. */
    private static CageVoxels withLow(int first, int second) {
        CageVoxels cage = cage();
        int slice = CageVoxels.COLUMNS * CageVoxels.ROWS;
        for (int v = 0; v < cage.labels.length; v++) {
            int number = CageVoxels.vertebra(0) - cage.labels[v];
            int above = v / slice - CageVoxels.vertebraSlice(number);
            if ((number == first || number == second) && above != -1 && above != 0) {
                cage.labels[v] = 0;
            }
        }
        return cage;
    }

    @Test
    void aTallVertebraAmongRightNumbersIsOne() {
        CageVoxels cage = withLow(7, 9);
        int slice = CageVoxels.COLUMNS * CageVoxels.ROWS;
        Segmentation s = scan(cage, CageVoxels.SLICES, label -> label);
        assertThat(new VertebraHeights(s).isDouble(8)).isTrue();
        byte[] fromT9 = Arrays.copyOfRange(cage.labels, (123 - 8 * 9 - 1) * slice, cage.labels.length);
        assertThat(new VertebraHeights(new Segmentation(CageVoxels.volume(fromT9), CageVoxels.table(false), "scan"))
                        .isDouble(8))
                .as("beside a vertebra that the scan cuts off")
                .isFalse();
        TreeMap<String, Integer> before = counts(s);
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(before);
    }

    /** Slices of a chest whose lower end cuts all ribs but the first seven, with lungs up to the first ribs. */
    private static Segmentation chest(IntUnaryOperator relabel) {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        cage.shorten(1, 34);
        for (int k = 48; k < 108; k++) {
            cage.ball(MIDDLE - 20, 30, k, 8, RIGHT_LUNG);
            cage.ball(MIDDLE + 20, 30, k, 8, LEFT_LUNG);
        }
        byte[] labels =
                Arrays.copyOfRange(cage.labels, CHEST * CageVoxels.COLUMNS * CageVoxels.ROWS, cage.labels.length);
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) relabel.applyAsInt(labels[v] & LabelGrid.MAX_BYTE_LABEL);
        }
        Map<Integer, String> table = new TreeMap<>(CageVoxels.table(false).structures());
        table.put(RIGHT_LUNG, "lung_R");
        table.put(LEFT_LUNG, "lung_L");
        return new Segmentation(CageVoxels.volume(labels), new LabelTable(table), "scan");
    }

    @Test
    void vertebraeOneOffTheRibsOfAChestFromTheFirstOnAreNumberedAnew() {
        Segmentation right = chest(label -> label);
        TreeMap<String, Integer> truth = counts(right);
        assertThat(truth).containsKeys("rib_09_R", "vertebra_T09").doesNotContainKeys("rib_11_R", "vertebra_T11");
        assertThat(VertebraNumbering.check(right)).isEmpty();
        Segmentation above = chest(vertebraeMoved(1));
        assertThat(BoneNumbering.numberRibs(above))
                .singleElement()
                .asString()
                .startsWith("the vertebrae lie one above the ribs of their numbers");
        assertThat(counts(above)).isEqualTo(truth);
    }

    /** Ribs 5 have no label, and those below are counted on: the vertebrae are right. */
    @Test
    void ribsCountedOnBelowOneWithoutALabelAreNumberedByTheirVertebrae() {
        TreeMap<String, Integer> truth = counts(chest(label -> label));
        truth.keySet().removeAll(List.of("rib_05_L", "rib_05_R"));
        Segmentation s = chest(label -> {
            boolean left = label >= CageVoxels.rib(5, false) && label <= CageVoxels.rib(12, false);
            boolean right = label >= CageVoxels.rib(5, true) && label <= CageVoxels.rib(12, true);
            boolean fifth = label == CageVoxels.rib(5, false) || label == CageVoxels.rib(5, true);
            return fifth ? 0 : left || right ? label - 1 : label;
        });
        assertThat(BoneNumbering.numberRibs(s)).singleElement().asString().startsWith("ribs, whose vertebrae lie one");
        assertThat(counts(s)).isEqualTo(truth);
    }

    @Test
    void elevenPairsOfRibsOneOffTheVertebraeAreNumberedAnew() {
        Segmentation s = scan(cage(), CageVoxels.SLICES, ribsMovedDown());
        assertThat(BoneNumbering.numberRibs(s)).singleElement().satisfies(note -> assertThat(note)
                .contains("ribs, whose vertebrae lie one below their numbers", "22"));
        assertThat(counts(s)).isEqualTo(truth(CageVoxels.SLICES, "rib_12_L", "rib_12_R"));
    }

    /** Ribs 1 to 11 with the numbers 2 to 12, and two copies of the last right one below it. */
    @Test
    void ribsThatCannotBeNumberedAnewKeepTheirNumbers() {
        CageVoxels cage = cage();
        int slice = CageVoxels.COLUMNS * CageVoxels.ROWS;
        byte[] labels = cage.labels.clone();
        for (int v = 16 * slice; v < labels.length; v++) {
            int label = labels[v] & LabelGrid.MAX_BYTE_LABEL;
            if (label == CageVoxels.rib(12, true)) {
                cage.labels[v] = 0;
            }
            if (label == CageVoxels.rib(11, true)) {
                cage.labels[v - 8 * slice] = (byte) label;
                cage.labels[v - 16 * slice] = (byte) label;
            }
        }
        Segmentation s = scan(cage, CageVoxels.SLICES, ribsMovedDown());
        TreeMap<String, Integer> before = counts(s);
        assertThat(VertebraNumbering.check(s))
                .get()
                .asString()
                .startsWith("ribs, whose vertebrae lie one below their numbers, which cannot be told apart: found 13")
                .endsWith("; ribs and vertebrae keep the numbers of their labels");
        assertThat(counts(s)).isEqualTo(before);
    }

    /**
     * Ribs that fall by another 0.4 mm for each millimetre beyond the transverse processes and, as segmentations leave
     * them, end 51 mm from the median plane.
     */
    private static CageVoxels withSteepRibsThatEndFarFromTheSpine() {
        CageVoxels cage = cage();
        byte[] before = cage.labels.clone();
        int slice = CageVoxels.COLUMNS * CageVoxels.ROWS;
        for (int v = 0; v < before.length; v++) {
            int label = before[v] & LabelGrid.MAX_BYTE_LABEL;
            double mm = CageVoxels.SPACING_MM * Math.abs(v % CageVoxels.COLUMNS - MIDDLE);
            int from = v + slice * (int) Math.round(0.4 * Math.min(30, Math.max(0, mm - 30)) / CageVoxels.SPACING_MM);
            boolean isRib = label >= FIRST_LEFT && label <= LAST_RIGHT;
            int rib = from < before.length ? before[from] & LabelGrid.MAX_BYTE_LABEL : 0;
            if (label == 0 || isRib) {
                cage.labels[v] = (byte) (mm >= 51 && rib >= FIRST_LEFT && rib <= LAST_RIGHT ? rib : 0);
            }
        }
        return cage;
    }

    @Test
    void numbersOfRibsThatEndFarFromTheSpineAreHeldAgainstWhereTheyWouldMeetIt() {
        CageVoxels cage = withSteepRibsThatEndFarFromTheSpine();
        assertThat(VertebraNumbering.check(scan(cage, CageVoxels.SLICES, label -> label)))
                .isEmpty();
        for (int down : new int[] {-1, 1}) {
            assertThat(VertebraNumbering.check(scan(cage, CageVoxels.SLICES, vertebraeMoved(down))))
                    .get()
                    .asString()
                    .contains(down < 0 ? "one below the ribs" : "one above the ribs");
        }
    }

    /** A scan of the cage with small balls at heights in the spine, whose vertebrae have names so many levels lower. */
    private static Segmentation named(int lower, Map<String, Integer> slices) {
        TreeMap<Integer, String> names = new TreeMap<>(CageVoxels.table(false).structures());
        for (int number = 1; number <= 12; number++) {
            int level = number + lower;
            names.put(
                    CageVoxels.vertebra(number),
                    level < 1
                            ? "vertebra_C7"
                            : level > 12 ? "vertebra_L01" : String.format(Locale.ROOT, "vertebra_T%02d", level));
        }
        CageVoxels cage = cage();
        int label = 0;
        for (Map.Entry<String, Integer> ball : new TreeMap<>(slices).entrySet()) {
            label++;
            names.put(label, ball.getKey());
            cage.ball(MIDDLE, 50, ball.getValue(), 1, label);
        }
        return new Segmentation(cage.volume(), new LabelTable(names), "scan");
    }

    @Test
    void discsAreNumberedAnewWithTheVertebraeAboutThem() {
        Segmentation s = named(1, Map.of("disc_L1_L2", 23, "disc_T12_L1", 31, "disc_T10_T11", 47));
        assertThat(BoneNumbering.numberRibs(s)).singleElement().satisfies(note -> assertThat(note)
                .contains("vertebra_L01 is vertebra_T12 now"));
        assertThat(s.labels("disc_T9_T10")).containsExactly(2);
        assertThat(s.labels("disc_T12_L1")).containsExactly(1);
        assertThat(s.labels("disc_T11_T12")).containsExactly(3);
        assertThat(counts(s))
                .containsKeys("disc_T9_T10", "disc_T11_T12", "disc_T12_L1")
                .doesNotContainKey("disc_L1_L2");
    }

    @Test
    void aVertebraWithoutANameAboveTheFirstIsLeftOut() {
        Map<String, Integer> neck = Map.of("disc_C1_C2", 125, "vertebra_C1", 128, "vertebra_C2", 122);
        Segmentation s = named(1, neck);
        int second = s.counts()[s.find("vertebra_C2")];
        assertThat(BoneNumbering.numberRibs(s)).singleElement().satisfies(note -> assertThat(note)
                .contains("vertebra_L01 is vertebra_T12 now; what lies above vertebra_C1 then is left out"));
        assertThat(s.labels("vertebra_C1")).containsExactly(3);
        assertThat(counts(s)).containsEntry("vertebra_C1", second).doesNotContainKeys("vertebra_C2", "disc_C1_C2");
    }

    @Test
    void aLumbarVertebraThatBecomesSacralJoinsTheSacralOneWithItsLabels() {
        Segmentation s = named(-1, Map.of("disc_L5_S1", 5, "vertebra_L05", 8, "vertebra_S1", 2));
        assertThat(BoneNumbering.numberRibs(s)).singleElement().satisfies(note -> assertThat(note)
                .contains("vertebra_T12 is vertebra_L01 now"));
        assertThat(s.labels("vertebra_S1")).containsExactlyInAnyOrder(2, 3);
        assertThat(s.labels("disc_L5_S1")).containsExactly(1);
        assertThat(counts(s)).containsKeys("vertebra_S1", "disc_L5_S1").doesNotContainKey("vertebra_L05");
    }

    /** Where the scan cuts off the first ribs the length of the last one tells which numbers are right. */
    @Test
    void inAnAbdomenALastRibAsShortAsTheTwelfthTellsThatVertebraeAreWrong() {
        Segmentation vertebrae = scan(cage(), ABDOMEN, vertebraeMoved(-1));
        assertThat(BoneNumbering.numberRibs(vertebrae)).singleElement().satisfies(note -> assertThat(note)
                .contains("the vertebrae lie one below"));
        assertThat(counts(vertebrae)).isEqualTo(truth(ABDOMEN));
        Segmentation ribs = scan(cage(), ABDOMEN, ribsMovedDown());
        assertThat(BoneNumbering.numberRibs(ribs)).singleElement().satisfies(note -> assertThat(note)
                .contains("ribs, whose vertebrae lie one below"));
        assertThat(counts(ribs)).isEqualTo(truth(ABDOMEN, "rib_12_L", "rib_12_R"));
    }
}
