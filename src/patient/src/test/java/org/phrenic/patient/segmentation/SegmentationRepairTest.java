package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.numbering.BoneNumbering;

class SegmentationRepairTest {
    /** Half way round the right third rib, in voxels of the cage. */
    private static final double[] RIGHT_OF_RIB_3 = {2.5, 30, 94};

    private static final int RIGHT_LUNG = 10;
    private static final int LEFT_LUNG = 11;

    /** Number of voxels of each structure. */
    private static TreeMap<String, Integer> counts(Segmentation s) {
        int[] counts = s.counts();
        TreeMap<String, Integer> byName = new TreeMap<>();
        for (int segment = 1; segment < counts.length; segment++) {
            if (counts[segment] > 0) {
                byName.put(s.names().get(segment - 1), counts[segment]);
            }
        }
        return byName;
    }

    /** Number of components of each structure across the faces of voxels. */
    private static TreeMap<String, Integer> pieces(Segmentation s) {
        VoxelRuns runs = VoxelRuns.ofSegments(s);
        TreeMap<String, Integer> pieces = new TreeMap<>();
        for (int run = 0; run < runs.count(); run++) {
            if (runs.component(run) == run) {
                int segment = s.voxels[runs.from(run)] & LabelGrid.MAX_BYTE_LABEL;
                pieces.merge(s.names().get(segment - 1), 1, Integer::sum);
            }
        }
        return pieces;
    }

    /** The lower slices of a cage are empty, as in a volume that was cropped and filled up to its former size. */
    @Test
    void aScanEndsWhereManyStructuresDoWhateverEmptySlicesFollow() {
        CageVoxels cropped = new CageVoxels().withRibs(1).withVertebrae(1);
        int slice = CageVoxels.COLUMNS * CageVoxels.ROWS;
        Arrays.fill(cropped.labels, 0, 50 * slice, (byte) 0);
        Segmentation s = cropped.segmentation(CageVoxels.table(false));
        s.findCuts();
        List<String> below =
                s.names().stream().filter(name -> sides(s, name).equals("I")).toList();
        assertThat(below).containsExactlyInAnyOrder("rib_08_L", "rib_08_R", "rib_09_L", "rib_09_R", "vertebra_T09");
        assertThat(s.names()).as("the upper ends are their own").noneMatch(name -> sides(s, name)
                .contains("S"));

        Segmentation whole = new CageVoxels().withRibs(1).withVertebrae(1).segmentation(CageVoxels.table(false));
        whole.findCuts();
        assertThat(whole.names()).allMatch(name -> whole.cuts(name).isEmpty());
    }

    /** In slices of 9 mm both first ribs, T1 and the tops of both lungs end in the uppermost one; nothing is cut. */
    @Test
    void aScanOfThickSlicesDoesNotEndWhereStructuresTaperOff() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        for (int side = -1; side <= 1; side += 2) {
            for (int k = 0; k < 60; k++) {
                cage.ball(44.5 + 20 * side, 28, 117 - k, Math.min(12, 0.9 * k), side < 0 ? RIGHT_LUNG : LEFT_LUNG);
            }
        }
        int slice = CageVoxels.COLUMNS * CageVoxels.ROWS;
        int thick = 3;
        byte[] labels = new byte[CageVoxels.SLICES / thick * slice];
        for (int k = 0; k < CageVoxels.SLICES / thick; k++) {
            System.arraycopy(cage.labels, (thick * k + 2) * slice, labels, k * slice, slice);
        }
        double mm = CageVoxels.SPACING_MM;
        LabelGrid grid =
                LabelGrid.of(CageVoxels.COLUMNS, CageVoxels.ROWS, CageVoxels.SLICES / thick, labels, new double[] {
                    mm, 0, 0, 0, 0, mm, 0, 0, 0, 0, thick * mm, 0
                });
        TreeMap<Integer, String> table = new TreeMap<>(CageVoxels.table(false).structures());
        table.put(RIGHT_LUNG, "lung_R");
        table.put(LEFT_LUNG, "lung_L");
        Segmentation s = new Segmentation(new LabelVolume(grid, Map.of(), List.of()), new LabelTable(table), "scan");
        int last = s.box(s.find("rib_01_R"))[5];
        assertThat(List.of("rib_01_L", "vertebra_T01", "lung_R", "lung_L"))
                .as("structures that end in the uppermost slice")
                .allMatch(name -> s.box(s.find(name))[5] == last);
        s.findCuts();
        assertThat(s.names()).allMatch(name -> s.cuts(name).isEmpty());
    }

    private static String sides(Segmentation s, String name) {
        return s.cuts(name).stream().map(CutPlane::side).collect(Collectors.joining());
    }

    private static TreeMap<String, Integer> repaired(Segmentation s) {
        BoneNumbering.numberRibs(s);
        SegmentationRepair.mend(s);
        return counts(s);
    }

    @Test
    void ribsWhoseNumbersSlipHalfWayRoundAreNumberedAnew() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        TreeMap<String, Integer> truth = repaired(cage.segmentation(CageVoxels.table(false)));
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean slips = label >= CageVoxels.rib(7, false) && label < CageVoxels.rib(12, false);
            // The anterior halves of left ribs 7 to 11 carry the next number.
            if (slips && v / CageVoxels.COLUMNS % CageVoxels.ROWS < 30) {
                cage.labels[v]++;
            }
        }
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(BoneNumbering.numberRibs(s)).singleElement().satisfies(note -> assertThat(note)
                .contains("holds parts of two ribs", "24"));
        SegmentationRepair.mend(s);
        assertThat(counts(s)).isEqualTo(truth);
        assertThat(s.labels("rib_07_L")).containsExactly(CageVoxels.rib(7, false), CageVoxels.rib(8, false));
    }

    /** The front halves of right ribs 6 and 9 carry labels of the left side, and ribs 3 exchange theirs. */
    @Test
    void ribsUnderLabelsOfTheOtherSideKeepTheirSide() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        TreeMap<String, Integer> truth = repaired(cage.segmentation(CageVoxels.table(false)));
        byte[] clean = cage.labels.clone();
        exchange(clean, cage.labels, 3, 3, CageVoxels.ROWS);
        Segmentation whole = cage.segmentation(CageVoxels.table(false));
        assertThat(BoneNumbering.numberRibs(whole)).singleElement().satisfies(note -> assertThat(note)
                .contains("names a rib of the other side", "24"));
        assertThat(nameNear(whole, RIGHT_OF_RIB_3)).isEqualTo("rib_03_R");
        exchange(clean, cage.labels, 6, 7, 34);
        exchange(clean, cage.labels, 9, 9, 34);
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(BoneNumbering.numberRibs(s)).hasSize(1);
        SegmentationRepair.mend(s);
        assertThat(counts(s)).isEqualTo(truth);
        assertThat(nameNear(s, RIGHT_OF_RIB_3)).isEqualTo("rib_03_R");
    }

    /** Gives what of a right rib lies before a row the label of a left one, and the other way round. */
    private static void exchange(byte[] from, byte[] to, int right, int left, int row) {
        for (int v = 0; v < from.length; v++) {
            int label = from[v] & LabelGrid.MAX_BYTE_LABEL;
            if (label == CageVoxels.rib(right, true) && v / CageVoxels.COLUMNS % CageVoxels.ROWS < row) {
                to[v] = (byte) CageVoxels.rib(left, false);
            } else if (label == CageVoxels.rib(left, false) && v / CageVoxels.COLUMNS % CageVoxels.ROWS < row) {
                to[v] = (byte) CageVoxels.rib(right, true);
            }
        }
    }

    /**
     * A scan of the abdomen that cuts off the backs of ribs 5 to 8, steep ones, of which what is left begins at one
     * height. In front of the body's axis ribs 7 to 11 carry the next number.
     */
    @Test
    void ribsWhoseVertebralEndsAreCutOffKeepTheirOrder() {
        CageVoxels cage = new CageVoxels();
        for (int number = 5; number <= 12; number++) {
            cage.ball(44.5, 50, 122 - 7 * number, 3.2, CageVoxels.vertebra(number));
            for (int step = 0; step <= 400; step++) {
                double angle = Math.PI * step / 400;
                double x = 36 * StrictMath.sin(angle) + 6;
                double z = 122 - 7 * number - 36 * angle / Math.PI;
                int slipped = number >= 7 && number <= 11 && angle > Math.PI / 2 ? number + 1 : number;
                cage.ball(44.5 - x, 30 + 22 * StrictMath.cos(angle), z, 1.6, CageVoxels.rib(slipped, true));
            }
        }
        int slices = 62;
        byte[] lower = Arrays.copyOf(cage.labels, CageVoxels.COLUMNS * CageVoxels.ROWS * slices);
        Segmentation cut = new Segmentation(CageVoxels.volume(lower), CageVoxels.table(false), "scan");
        assertThat(BoneNumbering.numberRibs(cut)).hasSize(1);
        for (int number = 5; number <= 12; number++) {
            double angle = 0.9 * Math.PI;
            double[] front = {
                44.5 - 36 * StrictMath.sin(angle) - 6, 30 + 22 * StrictMath.cos(angle), 122 - 7 * number - 32.4
            };
            assertThat(nameNear(cut, front)).isEqualTo(String.format(Locale.ROOT, "rib_%02d_R", number));
        }
    }

    /** Name of the structure at the voxel nearest to a place in voxels of the cage. */
    private static String nameNear(Segmentation s, double[] place) {
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int v = 0; v < s.voxels.length; v++) {
            double square = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = s.coordinate(v, axis) - CageVoxels.SPACING_MM * place[axis];
                square += d * d;
            }
            if (square < least) {
                least = square;
                nearest = v;
            }
        }
        return s.names().get(s.segmentAt(nearest) - 1);
    }

    /** A first rib in two pieces that meet with their ends, seen from the body's axis in the same directions. */
    @Test
    void piecesOfARibThatCurvesAboutTheAxisAreOneRib() {
        CageVoxels cage = new CageVoxels().withRibs(2).withVertebrae(1);
        for (int step = 0; step <= 200; step++) {
            if (step < 88 || step > 112) {
                double x = 10 + 0.15 * step;
                double y = 30 + 9 * Math.abs(StrictMath.sin(2 * Math.PI * step / 200));
                cage.ball(x, y, 122, 1.6, CageVoxels.rib(1, true));
            }
        }
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(pieces(s).get("rib_01_R")).isEqualTo(2);
        TreeMap<String, Integer> truth = counts(s);
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(truth);
    }

    @Test
    void specksOfAnAbsentRibInTheOthersDoNotChangeTheirNumbers() {
        CageVoxels cage = new CageVoxels().withRibs(3).withVertebrae(3);
        TreeMap<String, Integer> truth = counts(cage.segmentation(CageVoxels.table(false)));
        for (int v = 0; v < cage.labels.length; v += 97) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean speck = label >= CageVoxels.rib(5, true) && label <= CageVoxels.rib(7, true);
            cage.labels[v] = speck ? (byte) CageVoxels.rib(1, false) : cage.labels[v];
        }
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(counts(s)).containsKey("rib_01_L");

        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(truth);
    }

    /** The upper end takes the middle of a rib, whose two parts keep its number. */
    @Test
    void whatTheEndOfTheScanLeavesOfARibIsOneRib() {
        CageVoxels cage = new CageVoxels().withVertebrae(4);
        int last = CageVoxels.SLICES - 1;
        for (int step = 0; step <= 200; step++) {
            double angle = Math.PI * step / 200;
            double z = last - 12 + 20 * StrictMath.sin(angle);
            if (z < last - 0.7) {
                double x = 38.5 - 36 * StrictMath.sin(angle);
                cage.ball(x, 30 + 22 * StrictMath.cos(angle), z, 1.6, CageVoxels.rib(4, true));
            }
        }
        cage.withRibs(5);
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        int divided = pieces(s).get("rib_04_R");
        assertThat(divided).isEqualTo(2);
        TreeMap<String, Integer> truth = counts(s);
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(truth);
    }

    /**
     * A scan of the right side with floating ribs, in which the anterior halves of ribs 7 to 9 carry the next number.
     */
    @Test
    void ribsOfOneSideAreNumberedOnTheirSide() {
        CageVoxels cage = new CageVoxels().withRibs(1);
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean floating = label >= CageVoxels.rib(11, true) && v / CageVoxels.COLUMNS % CageVoxels.ROWS < 19;
            if (label < CageVoxels.rib(1, true) || floating) {
                cage.labels[v] = 0;
            }
        }
        TreeMap<String, Integer> truth = repaired(cage.segmentation(CageVoxels.table(false)));
        assertThat(truth).hasSize(12);
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean slips = label >= CageVoxels.rib(7, true) && label < CageVoxels.rib(10, true);
            if (slips && v / CageVoxels.COLUMNS % CageVoxels.ROWS < 30) {
                cage.labels[v]++;
            }
        }
        assertThat(repaired(cage.segmentation(CageVoxels.table(false)))).isEqualTo(truth);
    }

    /** A field of view that is narrower than the cage takes the side of each rib; backs and fronts keep the number. */
    @Test
    void ribsWhoseSidesAreNotInTheFieldOfViewKeepTheirNumbers() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        for (int v = 0; v < cage.labels.length; v++) {
            double x = v % CageVoxels.COLUMNS - 44.5;
            double y = v / CageVoxels.COLUMNS % CageVoxels.ROWS - 30;
            cage.labels[v] = x * x + y * y > 32 * 32 ? 0 : cage.labels[v];
        }
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(pieces(s).get("rib_07_R")).isGreaterThan(1);
        TreeMap<String, Integer> truth = counts(s);
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(truth);
    }

    /** Of a rib the scan shows two small pieces that meet in one direction from the body's axis. */
    @Test
    void twoSmallPiecesEndToEndAreOneRib() {
        CageVoxels cage = new CageVoxels().withRibs(5).withVertebrae(4);
        for (int step = 0; step <= 40; step++) {
            double t = step / 40.0;
            cage.ball(22 + 4 * t, 15 - 4.5 * t, 100, 1.6, CageVoxels.rib(4, true));
            cage.ball(22.5 + 5.5 * t, 6.9 - 2.9 * t, 100, 1.6, CageVoxels.rib(4, true));
        }
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(pieces(s).get("rib_04_R")).isEqualTo(2);
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
    }

    @Test
    void ribsUnderOneLabelAreNumberedByTheirVertebrae() {
        Segmentation s = new CageVoxels().withRibs(5).withVertebrae(5).segmentation(CageVoxels.table(true));
        TreeMap<String, Integer> truth =
                counts(new CageVoxels().withRibs(5).withVertebrae(5).segmentation(CageVoxels.table(false)));
        assertThat(repaired(s).keySet()).isEqualTo(truth.keySet());
    }

    @Test
    void ribsThatNothingNumbersAreRefused() {
        Segmentation s = new CageVoxels().withRibs(5).segmentation(CageVoxels.table(true));
        assertThatThrownBy(() -> BoneNumbering.numberRibs(s))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("8 connected ribs on the right and no vertebrae");
    }

    /** An arc as long as half a rib below the last right one. */
    @Test
    void moreThanTwelveRibsUnderOneLabelAreRefused() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        for (int step = 0; step <= 100; step++) {
            double angle = Math.PI * step / 200;
            double x = 44.5 - 36 * StrictMath.sin(angle) - 6;
            cage.ball(x, 30 + 22 * StrictMath.cos(angle), 16, 1.6, CageVoxels.rib(12, true));
        }
        Segmentation s = cage.segmentation(CageVoxels.table(true));
        assertThatThrownBy(() -> BoneNumbering.numberRibs(s))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 13 connected ribs on the right, expected at most 12");
    }

    /** Eleven ribs on the right, the third broken in front: its front piece lies along the back one for 40 of 90 mm. */
    @Test
    void aBrokenRibWhosePiecesOverrideKeepsItsNumberAndSoDoTheOthers() {
        CageVoxels cage = new CageVoxels().withRibs(4).withVertebrae(2);
        for (int step = 0; step <= 400; step++) {
            double angle = Math.PI * step / 400;
            for (int number = 2; number <= 3; number++) {
                double radius = number == 3 && step > 270 ? 29.5 : 36;
                double x = 44.5 - radius * StrictMath.sin(angle) - 6;
                double y = 30 + 22 * StrictMath.cos(angle) * radius / 36;
                double z = 124 - 8 * number - 12 * angle / Math.PI;
                cage.ball(x, y, z, 1.6, CageVoxels.rib(number, true));
                if (number == 3 && step > 270 && step < 330) {
                    cage.ball(
                            44.5 - 36 * StrictMath.sin(angle) - 6,
                            30 + 22 * StrictMath.cos(angle),
                            z,
                            1.6,
                            CageVoxels.rib(number, true));
                }
            }
        }
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(pieces(s).get("rib_03_R")).isEqualTo(2);
        TreeMap<String, Integer> truth = counts(s);
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        assertThat(counts(s)).isEqualTo(truth);
    }

    @Test
    void ribsThatTouchKeepTheirNumbers() {
        CageVoxels cage = new CageVoxels().withRibs(1);
        TreeMap<String, Integer> truth = repaired(cage.segmentation(CageVoxels.table(false)));
        for (int k = 60; k < 70; k++) {
            cage.ball(8, 30, k, 1.2, CageVoxels.rib(6, true));
        }
        TreeMap<String, Integer> touching = repaired(cage.segmentation(CageVoxels.table(false)));
        assertThat(touching.keySet()).isEqualTo(truth.keySet());
        truth.remove("rib_06_R");
        assertThat(touching).containsAllEntriesOf(truth);
    }

    @Test
    void droppedVoxelsBrokenRibsAndVerticesInPiecesAreMended() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        TreeMap<String, Integer> truth = repaired(cage.segmentation(CageVoxels.table(false)));
        Random random = new Random(5);
        for (int v = 0; v < cage.labels.length; v++) {
            int j = v / CageVoxels.COLUMNS % CageVoxels.ROWS;
            boolean vertebraCut = (cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.vertebra(6) && j == 50;
            boolean ribCut =
                    (cage.labels[v] & LabelGrid.MAX_BYTE_LABEL) == CageVoxels.rib(8, true) && j >= 28 && j < 32;
            if (random.nextDouble() < 0.05 || vertebraCut || ribCut) {
                cage.labels[v] = 0;
            }
        }
        // A speck far from its bone.
        cage.ball(2, 2, 2, 1, CageVoxels.vertebra(3));
        Segmentation s = cage.segmentation(CageVoxels.table(false));
        assertThat(BoneNumbering.numberRibs(s)).isEmpty();
        List<String> notes = SegmentationRepair.mend(s);
        assertThat(notes).anyMatch(note -> note.contains("joined") && note.contains("rib_08_R (2)"));
        assertThat(pieces(s).values()).containsOnly(1);
        counts(s).forEach((name, voxels) -> assertThat(voxels / (double) truth.get(name))
                .as(String.format(Locale.ROOT, "volume of %s to that of the whole bone", name))
                .isCloseTo(1, within(0.12)));
    }

    /** The first face of a hole in the liver is one of a vessel; the other 149 are of the liver. */
    @Test
    void aHoleBelongsToTheStructureOfMostOfItsFaces() {
        int n = 20;
        byte[] labels = new byte[n * n * n];
        for (int v = 0; v < labels.length; v++) {
            int i = v % n;
            int j = v / n % n;
            int k = v / n / n;
            boolean inner = Math.min(i, Math.min(j, k)) >= 2 && Math.max(i, Math.max(j, k)) <= 16;
            boolean hole = Math.min(i, Math.min(j, k)) >= 7 && Math.max(i, Math.max(j, k)) <= 11;
            labels[v] = (byte) (hole ? 0 : inner ? 1 : 0);
        }
        labels[6 + n * (7 + n * 7)] = 2;
        LabelGrid grid = LabelGrid.of(n, n, n, labels, new double[] {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0});
        Segmentation s = new Segmentation(
                new LabelVolume(grid, Map.of(), List.of()), new LabelTable(Map.of(1, "liver", 2, "aorta")), "scan");
        assertThat(HoleFilling.fill(s)).isEqualTo(125);
        assertThat(counts(s)).containsEntry("liver", 15 * 15 * 15 - 1).containsEntry("aorta", 1);
    }

    /**
     * Single voxels of wrong labels all over the volume: of bones they are left out, and alone they are no structure.
     */
    @Test
    void specksAreLeftOutAndWhatIsNothingElseIsNoStructure() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(2);
        TreeMap<String, Integer> truth = repaired(cage.segmentation(CageVoxels.table(false)));
        Random random = new Random(3);
        for (int n = 0; n < 3000; n++) {
            int v = random.nextInt(cage.labels.length);
            boolean nothing = n % 2 == 0;
            cage.labels[v] = (byte) (nothing ? CageVoxels.vertebra(1) : CageVoxels.rib(1 + n % 12, n % 4 == 1));
        }
        TreeMap<String, Integer> mended = repaired(cage.segmentation(CageVoxels.table(false)));
        assertThat(mended.keySet()).isEqualTo(truth.keySet());
        mended.forEach((name, voxels) ->
                assertThat(voxels / (double) truth.get(name)).as(name).isCloseTo(1, within(0.03)));
    }

    /** A voxel with another rib's label in the middle of a cartilage gives no part of it to that rib. */
    @Test
    void aSpeckOfARibHasNoCartilage() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        int cartilage = 117;
        for (int step = 0; step <= 60; step++) {
            cage.ball(39 + step / 6.0, 8, 124 - 8 * 6 - 12, 1.6, cartilage);
        }
        cage.labels[44 + CageVoxels.COLUMNS * (8 + CageVoxels.ROWS * 64)] = (byte) CageVoxels.rib(3, false);
        TreeMap<Integer, String> structures =
                new TreeMap<>(CageVoxels.table(false).structures());
        structures.put(cartilage, LabelTable.COSTAL_CARTILAGES);
        Segmentation s = cage.segmentation(new LabelTable(structures));
        CartilageSplitter.split(s);
        assertThat(counts(s)).containsKey("costal_cartilage_06_R").doesNotContainKey("costal_cartilage_03_L");
    }

    /**
     * Spleen, liver, lungs, colon and aorta as balls, and small balls under their labels: one near the spleen, one of
     * the left lung near the right one, a loop of the colon of 2.5 ml, and five far from their organs, of which one
     * lies within the liver.
     */
    @Test
    void smallPartsAwayFromTheirOrganAreLeftOut() {
        LabelTable table = new LabelTable(
                Map.of(1, "spleen", 2, "liver", 3, "lung_L", 4, "lung_R", 5, "colon", 6, "aorta", 7, "liver_vessels"));
        CageVoxels clean = new CageVoxels();
        clean.ball(70, 40, 30, 8, 1);
        clean.ball(82, 40, 30, 1.5, 1);
        clean.ball(19, 30, 40, 4, 7);
        clean.ball(33, 30, 40, 1.8, 7);
        clean.ball(25, 30, 40, 12, 2);
        clean.ball(65, 30, 95, 14, 3);
        clean.ball(43, 30, 95, 2.2, 3);
        clean.ball(25, 30, 95, 14, 4);
        clean.ball(60, 30, 50, 6, 5);
        clean.ball(75, 30, 60, 2.8, 5);
        clean.ball(45, 45, 60, 5, 6);
        CageVoxels scan = new CageVoxels();
        scan.ball(25, 30, 40, 1.5, 1);
        scan.ball(20, 45, 70, 1.5, 1);
        scan.ball(60, 20, 10, 2.2, 4);
        scan.ball(20, 10, 70, 1.5, 5);
        scan.ball(70, 10, 70, 1.5, 6);
        for (int v = 0; v < scan.labels.length; v++) {
            scan.labels[v] = scan.labels[v] == 0 ? clean.labels[v] : scan.labels[v];
        }
        Segmentation s = scan.segmentation(table);
        List<String> notes = SegmentationRepair.mend(s);
        assertThat(counts(s)).isEqualTo(counts(clean.segmentation(table)));
        assertThat(pieces(s))
                .isEqualTo(Map.of(
                        "spleen", 2, "liver", 1, "lung_L", 2, "lung_R", 1, "colon", 2, "aorta", 1, "liver_vessels", 2));
        assertThat(notes)
                .containsExactly("parts that lie away from their organ are left out: spleen (1.0 ml), lung_R (0.9 ml),"
                        + " colon (0.5 ml), aorta (0.5 ml)");
    }
}
