package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.segmentation.CageVoxels;

class LabelGuessTest {
    /** Words of a message in a name are no refusal of the volume. */
    @Test
    void aVolumeOfUnknownNamesMayHaveATable() {
        LabelGrid grid = LabelGrid.of(2, 1, 1, new byte[] {1, 2}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        LabelGuess guess = LabelGuess.of(new LabelVolume(grid, Map.of(1, "quux, expected quuz"), List.of()));
        assertThat(guess.isRefused()).isFalse();
        assertThatThrownBy(() -> guess.require("case")).hasMessageContaining(", expected --labels with a table");
    }

    @Test
    void aidsOfAPlanAloneAreNoBody() {
        LabelGrid grid = LabelGrid.of(2, 1, 1, new byte[] {1, 2}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        LabelGuess guess = LabelGuess.of(new LabelVolume(grid, Map.of(1, "Ring_2cm", 2, "Isodose_50"), List.of()));
        assertThat(guess.table()).isEmpty();
        assertThat(guess.reason()).contains("no name of a structure: 'Ring_2cm'");
    }

    @ParameterizedTest
    @CsvSource({
        "Right Lung, lung_R",
        "lung_upper_lobe_left, lung_L",
        "lungs, lungs",
        "rib 5 left, rib_05_L",
        "Rib_R_11, rib_11_R",
        "ribs, ribs",
        "T12, vertebra_T12",
        "vertebrae_L3, vertebra_L03",
        "vertebrae_C7, vertebra_C7",
        "costal cartilages, costal_cartilages",
        "Manubrium, sternum_manubrium",
        "kidney right, kidney_R",
        "Gall bladder, gallbladder",
        "esophagus, oesophagus",
        "clavicula_left, clavicle_L",
        "iliac vena left, iliac_vein_L",
        "liver tumor 2, lesion_liver_tumor_2",
        "body_trunc, skin",
        "body_extremities, ignore",
        "subcutaneous_fat, skin",
        "skeletal_muscle, muscle_skeletal",
        "leftlung, lung_L",
        "SpinalCord, spinal_cord",
        "Lung_R, lung_R",
        "KIDNEY_L, kidney_L",
        "Vertebra_t05, vertebra_T05",
        "LIVER, liver",
        "A_Aorta, aorta",
        "V_Venacava_I, inferior_vena_cava",
        "Bowel_Small, small_bowel",
        "VB_T05, vertebra_T05",
        "Rib07_L, rib_07_L",
        "External, skin",
        "GTVp, lesion_gtvp",
        "bones, bone_skeleton",
        "spine, bone_spine",
        "right lung lower lobe, lung_R",
        "lung_vessels, lungs",
        "lung_trachea_bronchia, trachea",
        "lung_nodules, lesion_lung_nodules",
        "liver_segment_4, liver",
        "liver_segment_IVa, liver",
        "left liver lobe, liver",
        "liver_vessels, liver_vessels",
        "hepatic vessel, liver_vessels",
        "livertumor01, lesion_livertumor01",
        "portalvein, portal_vein",
        "heart_ventricle_left, heart",
        "myocardium, heart",
        "atrial_appendage_left, atrial_appendage_L",
    })
    void namesOfFilesStandForStructures(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    @ParameterizedTest
    @CsvSource({
        "Leber, liver",
        "Lunge rechts, lung_R",
        "linker Lungenflügel, lung_L",
        "linker_Lungenfluegel, lung_L",
        "5. Rippe links, rib_05_L",
        "Rippen, ribs",
        "BWK 5, vertebra_T05",
        "LWK1, vertebra_L01",
        "Th12, vertebra_T12",
        "Wirbelsäule, bone_spine",
        "foie, liver",
        "Poumon gauche, lung_L",
        "cote_7_droite, rib_07_R",
        "cœur, heart",
        "pulmón derecho, lung_R",
        "riñón izquierdo, kidney_L",
        "hígado, liver",
        "polmone sinistro, lung_L",
        "rene destro, kidney_R",
        "coração, heart",
        "pulmo dexter, lung_R",
        "hepar, liver",
        "右肺, lung_R",
        "左肺上叶, lung_L",
        "肝臓, liver",
        "肋骨, ribs",
        "右肾, kidney_R",
        "Pfortader, portal_vein",
        "Lebervenen, hepatic_vein",
        "untere Hohlvene, inferior_vena_cava",
        "Lungenoberlappen links, lung_L",
        "Unterlappen rechts, lung_R",
        "Brustwirbel 5, vertebra_T05",
        "Nieren, organ_kidneys",
        "Nebenniere rechts, adrenal_gland_R",
        "Rueckenmark, spinal_cord",
        "Dünndarm, small_bowel",
        "rate, spleen",
        "vésicule biliaire, gallbladder",
        "veine porte, portal_vein",
        "veine cave inférieure, inferior_vena_cava",
        "veines sus-hépatiques, hepatic_vein",
        "pancréas, pancreas",
        "intestin grêle, small_bowel",
        "moelle épinière, spinal_cord",
        "colonne vertébrale, bone_spine",
        "riñones, organ_kidneys",
        "vena porta, portal_vein",
        "vesícula biliar, gallbladder",
        "columna vertebral, bone_spine",
        "midollo spinale, spinal_cord",
        "cistifellea, gallbladder",
        "rins, organ_kidneys",
        "门静脉, portal_vein",
        "下腔静脉, inferior_vena_cava",
        "左腎, kidney_L",
        "気管, trachea",
        "肋软骨, costal_cartilages",
    })
    void namesInOtherLanguagesAreKnown(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** Words of other languages leave English names as they are. */
    @Test
    void noEnglishNameHoldsAWordOfAnotherLanguage() {
        assertThat(NumberTable.ALL)
                .flatExtracting(table -> table.names().keySet())
                .allSatisfy(name -> assertThat(LabelWords.english(name)).isEqualTo(name.toLowerCase(Locale.ROOT)));
    }

    @Test
    void nothingIsMadeOfAnUnknownName() {
        assertThat(List.of("rib 13 left", "rib left", "T13", "segment 4", "vertebrae_body", "pericardial fat", "1", ""))
                .allSatisfy(name -> assertThat(LabelNames.structure(name)).isEmpty());
    }

    private static LabelVolume cage(double zPerSlice, Map<Integer, String> names) {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        double s = CageVoxels.SPACING_MM;
        LabelGrid grid =
                LabelGrid.of(CageVoxels.COLUMNS, CageVoxels.ROWS, CageVoxels.SLICES, cage.labels, new double[] {
                    s, 0, 0, 0, 0, s, 0, 0, 0, 0, zPerSlice, 0
                });
        return new LabelVolume(grid, names, List.of());
    }

    /** A volume without names whose labels are other ones. */
    private static LabelVolume relabelled(LabelVolume volume, IntUnaryOperator change) {
        LabelGrid grid = volume.grid();
        byte[] labels = new byte[grid.voxelCount()];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) change.applyAsInt(grid.label(v));
        }
        LabelGrid other = LabelGrid.of(grid.columns(), grid.rows(), grid.slices(), labels, grid.toMm());
        return new LabelVolume(other, Map.of(), List.of());
    }

    @Test
    void numbersOfTotalSegmentatorAreTakenWhereTheirPlacesFit() {
        LabelGuess guess = LabelGuess.of(cage(CageVoxels.SPACING_MM, Map.of()));
        assertThat(guess.source()).isEqualTo(LabelGuess.Source.NUMBERS);
        assertThat(guess.confidence()).isEqualTo(1);
        assertThat(guess.table().orElseThrow().structures())
                .containsEntry(92, "rib_01_L")
                .containsEntry(115, "rib_12_R");
    }

    /** Numbers fit upside down, and the axes are told; numbers in any order fit in no axes. */
    @Test
    void numbersOfTotalSegmentatorAreTakenWhereTheirPlacesFitInOtherAxes() {
        LabelGuess guess = LabelGuess.of(cage(-CageVoxels.SPACING_MM, Map.of()));
        assertThat(guess.source()).isEqualTo(LabelGuess.Source.NUMBERS);
        assertThat(guess.reason()).endsWith("fit if the axes are LPS");
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        for (int v = 0; v < cage.labels.length; v++) {
            int label = cage.labels[v] & 0xff;
            cage.labels[v] = (byte) (label == 0 ? 0 : 32 + (37 * label + 11) % 84);
        }
        LabelGuess none = LabelGuess.of(cage.volume());
        assertThat(none.source()).isEqualTo(LabelGuess.Source.NONE);
        assertThatThrownBy(() -> none.require("scan"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("which fit numbers of no known tool or data set");
    }

    /** Lobes 10 to 14 of a scan of the lungs alone: upper and lower left, upper, middle and lower right. */
    @Test
    void fiveLobesAloneAreRecognisedByTheirNumbers() {
        double[][] centres = {{60, 30, 90}, {60, 40, 60}, {25, 30, 90}, {25, 20, 70}, {25, 40, 60}};
        CageVoxels lungs = new CageVoxels();
        for (int lobe = 0; lobe < centres.length; lobe++) {
            lungs.ball(centres[lobe][0], centres[lobe][1], centres[lobe][2], 16, 10 + lobe);
        }
        LabelGuess guess = LabelGuess.of(lungs.volume());
        assertThat(guess.source()).isEqualTo(LabelGuess.Source.NUMBERS);
        assertThat(guess.table().orElseThrow().structures())
                .containsEntry(11, "lung_L")
                .containsEntry(13, "lung_R");
        // Upside down the sides alone are right, which is not enough.
        LabelVolume down = GeometryOverride.axes(lungs.volume(), "LPI");
        assertThat(LabelGuess.of(down).source()).isEqualTo(LabelGuess.Source.NONE);
    }

    /** Ribs 1 left to 12 right are 92 to 115 in version 2 and 58 to 81 in version 1, L5 to T1 27 to 43 and 18 to 34. */
    @Test
    void numbersOfTheFirstVersionAreTakenWhereTheyFitBetter() {
        LabelVolume second = cage(CageVoxels.SPACING_MM, Map.of());
        LabelVolume first = relabelled(second, label -> label == 0 ? 0 : label >= 92 ? label - 34 : label - 9);
        assertThat(LabelGuess.of(first).require("scan").structures())
                .containsEntry(58, "rib_01_L")
                .containsEntry(81, "rib_12_R")
                .containsEntry(34, "vertebra_T01");
        assertThat(LabelTable.of("totalsegmentator", first).structures()).containsEntry(81, "rib_12_R");
        assertThat(LabelTable.of("totalsegmentator", second).structures()).containsEntry(115, "rib_12_R");
    }

    static List<NumberTable> tables() {
        return NumberTable.ALL;
    }

    /** One trunk in the numbers of each tool: no table but its own is taken, and all of its labels come out. */
    @ParameterizedTest
    @MethodSource("tables")
    void numbersOfEachToolAreToldFromThoseOfOthers(NumberTable table) {
        LabelVolume trunk = TrunkVoxels.labelled(table);
        LabelGuess guess = LabelGuess.of(trunk);
        assertThat(guess.reason()).startsWith("labels are taken for numbers of " + table.title() + ":");
        int[] counts = trunk.grid().counts();
        Map<Integer, String> present = new TreeMap<>(table.structures());
        present.keySet().removeIf(label -> label >= counts.length || counts[label] == 0);
        assertThat(guess.table().orElseThrow().structures()).isEqualTo(present);
    }

    /** Liver and lungs stand in one place and have one volume in three tables: none is taken. */
    @Test
    void numbersThatFitSeveralToolsAreNotTaken() {
        LabelVolume trunk = TrunkVoxels.labelled(NumberTable.named("ct-org").get(0));
        LabelVolume liver = relabelled(trunk, label -> label == 1 ? 1 : 0);
        assertThat(LabelGuess.of(liver).source()).isEqualTo(LabelGuess.Source.NONE);
    }

    /** A trunk whose labels are these structures from 1 on. */
    private static LabelVolume numbered(String structures) {
        Map<Integer, String> byLabel = new TreeMap<>();
        for (String structure : structures.split(" ", -1)) {
            byLabel.put(byLabel.size() + 1, structure);
        }
        return TrunkVoxels.labelled(new NumberTable("own", "own", byLabel, Map.of(), Map.of()));
    }

    /** Structures that somebody numbered from 1 are of no tool, though some lie and compare as a tool's do. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "oesophagus heart trachea aorta",
                "oesophagus heart lung_L lung_R",
                "lung_L lung_R heart",
                "kidney_R kidney_L",
                "vertebra_L01 vertebra_L02 vertebra_L03 vertebra_L04 vertebra_L05",
                "vertebra_T01 vertebra_T02 vertebra_T03 vertebra_T04 vertebra_T05 vertebra_T06 vertebra_T07"
                        + " vertebra_T08 vertebra_T09 vertebra_T10 vertebra_T11 vertebra_T12",
            })
    void aFewStructuresNumberedByAnybodyAreOfNoTool(String structures) {
        assertThat(LabelGuess.of(numbered(structures)).source()).isEqualTo(LabelGuess.Source.NONE);
    }

    /** Two lungs or five lobes are few comparisons: other organs on two sides make them as well. */
    @ParameterizedTest
    @CsvSource({
        "oesophagus heart lung_L lung_R aorta, lung_R",
        "heart spleen lung_R liver kidney_R, lung_L",
        "lung_R heart, lung_L",
    })
    void otherStructuresNumberedAsLungsAreNoLungs(String structures, String other) {
        LabelGuess guess = LabelGuess.of(numbered(structures));
        assertThat(guess.table().map(LabelTable::structures).orElse(Map.of()).values())
                .doesNotContain(other);
        assertThat(LabelGuess.of(numbered("lung_R lung_L")).require("scan").structures())
                .containsEntry(1, "lung_R");
    }

    /** The same numbers are ribs in another table: a spine that leans to a side is a spine. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.1, 0.1})
    void aLeaningSpineIsNotTakenForRibs(double lean) {
        LabelVolume spine = TrunkVoxels.labelled(NumberTable.named("verse").get(0));
        double[] toMm = spine.grid().toMm();
        toMm[2] = lean * toMm[10];
        LabelGuess guess = LabelGuess.of(new LabelVolume(spine.grid().withAffine(toMm), Map.of(), List.of()));
        assertThat(guess.require("scan").structures()).containsEntry(8, "vertebra_T01");
    }

    /** Ribs 1 to 12 of the right side, then of the left one, lie in no one column. */
    @Test
    void ribsNumberedFromTheRightAreNotTakenForVertebrae() {
        LabelVolume ribs = TrunkVoxels.labelled(NumberTable.named("ribseg").get(0));
        LabelGuess guess = LabelGuess.of(relabelled(ribs, label -> label == 0 ? 0 : 1 + (label + 11) % 24));
        assertThat(guess.table().map(LabelTable::structures).orElse(Map.of()).values())
                .noneMatch(structure -> structure.startsWith("vertebra"));
    }

    /** Ribs 1 to 24 from the right or from below fit RibSeg in a mirrored or turned body; they tell no axes. */
    @Test
    void ribsCountedInAnotherOrderTellNoAxes() {
        LabelVolume ribs = TrunkVoxels.labelled(NumberTable.named("ribseg").get(0));
        assertThat(List.<IntUnaryOperator>of(label -> 1 + (label + 11) % 24, label -> 1 + (36 - label) % 24))
                .allSatisfy(order -> assertThatThrownBy(
                                () -> LabelGuess.of(relabelled(ribs, label -> label == 0 ? 0 : order.applyAsInt(label)))
                                        .require("scan"))
                        .isInstanceOf(BadInputException.class)
                        .hasMessageContaining("fit numbers of RibSeg if the axes are ")
                        .hasMessageContaining("but may count bones in another order as well, expected --labels"));
    }

    /** Ribs on each other's sides are no structures of another tool that has the same numbers for organs. */
    @Test
    void ribsWhoseSidesAreExchangedAreToldAsSuch() {
        LabelVolume trunk =
                TrunkVoxels.labelled(NumberTable.named("totalsegmentator").get(0));
        LabelVolume exchanged =
                relabelled(trunk, label -> label < 92 || label > 115 ? label : label < 104 ? label + 12 : label - 12);
        assertThatThrownBy(() -> LabelGuess.of(exchanged).require("scan"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining(
                        "fit numbers of TotalSegmentator 2 but for right and left structures, which are exchanged");
    }

    /** Five of CT-ORG's six labels fit many orders of structures by volume alone. */
    @ParameterizedTest
    @ValueSource(strings = {"heart kidney_R lungs stomach", "liver organ_kidneys lungs ribs"})
    void structuresThatLieElsewhereAreNotThoseOfAShortTable(String structures) {
        assertThat(LabelGuess.of(numbered(structures)).source()).isEqualTo(LabelGuess.Source.NONE);
    }

    /** Two ribs, or two of many other structures, have such numbers. */
    @Test
    void aFewLabelsFromOneNameNoTool() {
        assertThat(LabelGuess.of(numbered("liver spleen")).reason())
                .isEqualTo("found labels 1, 2 without names, which are too few to tell whose numbers they are");
        LabelVolume lungs = numbered("lung_L lung_R liver");
        assertThat(LabelGuess.of(relabelled(lungs, label -> label == 3 ? 0 : label))
                        .reason())
                .doesNotContain("fit numbers of RibSeg");
    }

    /** Organs of FLARE that are all cut off, so that no volumes are compared, and two small ones exchanged. */
    @Test
    void onePlaceMayFailWhereSeveralStructuresLieAsTheToolsDo() {
        LabelVolume cut = cutOff(TrunkVoxels.labelled(NumberTable.named("flare").get(0)));
        LabelGuess guess = LabelGuess.of(relabelled(cut, label -> label == 7 ? 8 : label == 8 ? 7 : label));
        assertThat(guess.require("scan").structures()).containsEntry(1, "liver").containsEntry(9, "gallbladder");
        assertThat(guess.confidence()).isLessThan(1);
    }

    /**
     * Labels 26 to 35 are S1 to T9 in version 2 of TotalSegmentator and T9 to C7 in version 1, where 10 to 14 are
     * pancreas, adrenal glands and the left lung.
     */
    @Test
    void theLiverTellsTheVersionOfVertebrae() {
        LabelVolume trunk =
                TrunkVoxels.labelled(NumberTable.named("totalsegmentator").get(0));
        LabelVolume few = relabelled(
                trunk, label -> label == 21 ? 26 : label == 5 || label == 11 || (label > 26 && label < 36) ? label : 0);
        assertThat(LabelTable.of("totalsegmentator", few).structures())
                .containsEntry(5, "liver")
                .containsEntry(11, "lung_L")
                .containsEntry(27, "vertebra_L05");
    }

    /** A volume with a voxel of each label in its first slice, so that no organ is whole. */
    private static LabelVolume cutOff(LabelVolume volume) {
        LabelGrid grid = volume.grid();
        int[] counts = grid.counts();
        byte[] labels = new byte[grid.voxelCount()];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) (v < counts.length && counts[v] > 0 && v > 0 ? v : grid.label(v));
        }
        LabelGrid cut = LabelGrid.of(grid.columns(), grid.rows(), grid.slices(), labels, grid.toMm());
        return new LabelVolume(cut, volume.names(), volume.notes());
    }

    /** Organs tell axes, also where none is whole and no volumes are compared. */
    @Test
    void organsThatAreCutOffAreNoBonesInAnotherOrder() {
        LabelVolume trunk =
                cutOff(TrunkVoxels.labelled(NumberTable.named("cads").get(0)));
        LabelVolume down = GeometryOverride.axes(trunk, "LPI");
        assertThat(LabelGuess.of(down).reason())
                .startsWith("labels are taken for numbers of TotalSegmentator 1:")
                .endsWith("fit if the axes are LPS");
    }

    /** Numbers half way between those of two structures are of no tool. */
    @Test
    void interpolatedLabelsHaveNoTable() {
        LabelVolume trunk = TrunkVoxels.labelled(NumberTable.named("amos").get(0));
        LabelGrid grid = trunk.grid();
        int[] voxel = {0};
        LabelVolume halfWay = relabelled(trunk, label -> {
            int before = voxel[0] == 0 ? 0 : grid.label(voxel[0] - 1);
            voxel[0]++;
            return (int) Math.round(0.5 * (before + label));
        });
        LabelGuess guess = LabelGuess.of(halfWay);
        assertThat(guess.isRefused()).isTrue();
        assertThatThrownBy(() -> guess.require("scan"))
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith("scan: found layers of numbers between those of two structures")
                .hasMessageEndingWith("expected each voxel with the label of the nearest one");
    }

    /** Numbers beside names are those of the reader; numbers alone, as of segments without a name, are the tool's. */
    @Test
    void numbersOfLabelsWithUnknownNamesAreOfNoTool() {
        LabelVolume cage = cage(CageVoxels.SPACING_MM, Map.of(92, "quux", 93, "Segment 93"));
        assertThatThrownBy(() -> LabelGuess.of(cage).require("scan"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found labels with no name of a structure: 'quux', expected --labels");
        LabelVolume numbers = cage(CageVoxels.SPACING_MM, Map.of(92, "Segment 92", 93, "93"));
        assertThat(LabelGuess.of(numbers).require("scan").structures()).containsEntry(92, "rib_01_L");
    }

    @Test
    void greyValuesAreToldFromLabels() {
        LabelVolume labels = cage(CageVoxels.SPACING_MM, Map.of());
        int[] voxel = {0};
        LabelVolume grey = relabelled(labels, label -> 1 + 7 * voxel[0]++ % 200);
        assertThatThrownBy(() -> LabelGuess.of(grey).require("scan"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found grey values, as of an image that has to be segmented first");
        assertThat(labels.isImage()).isFalse();
    }

    /** A spleen as large as a liver, and the reverse, is a volume in another order of labels. */
    @Test
    void volumesTellWhatPlacesLeaveOpen() {
        NumberTable table = NumberTable.named("amos").get(0);
        LabelVolume trunk = TrunkVoxels.labelled(table);
        Map<Integer, Integer> exchanged = Map.of(6, 4, 4, 6, 7, 5, 5, 7);
        LabelVolume other = relabelled(trunk, label -> exchanged.getOrDefault(label, label));
        LabelVolumes volumes = LabelVolumes.of(NumberMatch.positions(other.grid()), table.structures());
        LabelVolumes right = LabelVolumes.of(NumberMatch.positions(trunk.grid()), table.structures());
        assertThat(right.share()).isEqualTo(1);
        assertThat(volumes.compared()).isEqualTo(right.compared());
        assertThat(volumes.share()).isLessThan(0.6);
    }

    /**
     * Of ribs with even numbers the anterior fifths are there, of the others the posterior ones: the middle of rib 4
     * lies below that of rib 5.
     */
    @Test
    void ribsAreComparedWhereBothAreShown() {
        LabelVolume whole = cage(CageVoxels.SPACING_MM, Map.of());
        byte[] labels = new byte[whole.grid().voxelCount()];
        for (int v = 0; v < labels.length; v++) {
            int label = whole.grid().label(v);
            int j = v / CageVoxels.COLUMNS % CageVoxels.ROWS;
            boolean even = label >= CageVoxels.rib(1, false) && label % 2 == CageVoxels.rib(2, false) % 2;
            boolean kept = label < CageVoxels.rib(1, false) || (even ? j < 14 : j > 46);
            labels[v] = (byte) (kept ? label : 0);
        }
        LabelGrid parts = LabelGrid.of(CageVoxels.COLUMNS, CageVoxels.ROWS, CageVoxels.SLICES, labels, new double[] {
            3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0
        });
        LabelGuess guess = LabelGuess.of(new LabelVolume(parts, Map.of(), List.of()));
        assertThat(guess.source()).isEqualTo(LabelGuess.Source.NUMBERS);
        assertThat(guess.confidence()).isEqualTo(1);
    }

    @Test
    void aLabelThatEnclosesAllOthersIsTheSkinAndUnknownOnesAreObstacles() {
        LabelVolume bare = cage(CageVoxels.SPACING_MM, Map.of());
        byte[] labels = new byte[bare.grid().voxelCount()];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) (bare.grid().label(v) == 0 ? 200 : bare.grid().label(v));
        }
        labels[1] = (byte) 150;
        LabelGrid grid = LabelGrid.of(CageVoxels.COLUMNS, CageVoxels.ROWS, CageVoxels.SLICES, labels, new double[] {
            3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0
        });
        Map<Integer, String> structures = LabelGuess.of(new LabelVolume(grid, Map.of(), List.of()))
                .require("scan")
                .structures();
        assertThat(structures).containsEntry(200, "skin").containsEntry(150, "other_150");
        Map<Integer, String> names = Map.of(150, "liver", 200, "Isodose_5Gy");
        assertThat(LabelGuess.of(new LabelVolume(grid, names, List.of()))
                        .require("scan")
                        .structures())
                .containsEntry(200, "other_planning-isodose_5gy");
    }
}
