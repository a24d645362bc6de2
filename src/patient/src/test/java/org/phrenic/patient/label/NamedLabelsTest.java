package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.segmentation.CageVoxels;

/** Names of masks in which all share words, and ribs of a side under one name. */
class NamedLabelsTest {
    private static List<String> structures(List<String> names) {
        return SharedWords.removed(names).stream()
                .map(name -> LabelNames.structure(name).orElse("-"))
                .toList();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "s0011_%s",
                "s0011-%s",
                "case_00012_%s_seg",
                "case_3_%s",
                "%s_BDMAP_1",
                "%s_BDMAP_00000001",
                "BDMAP_00000001_%s",
                "LIDC-IDRI-0001_%s_mask",
                "patient 7 ct %s",
                "00012_%s",
                "%s.manual",
                "OPT_003_%s",
                "RING01_%s",
                "DOSE2_%s",
            })
    void wordsForACaseOrAFileAreNoPartOfNames(String pattern) {
        List<String> names = List.of("liver", "lung_left", "kidney_right", "rib_left_12", "vertebrae_T5", "spleen");
        assertThat(structures(
                        names.stream().map(name -> String.format(pattern, name)).toList()))
                .containsExactly("liver", "lung_L", "kidney_R", "rib_12_L", "vertebra_T05", "spleen");
    }

    @Test
    void theMaskOfOneStructureHasNoNumberOfACase() {
        assertThat(structures(List.of("s0011_liver"))).containsExactly("liver");
        assertThat(structures(List.of("liver_BDMAP_00000001"))).containsExactly("liver");
    }

    @Test
    void theNumberOfACaseIsNotThatOfARib() {
        List<String> names = IntStream.rangeClosed(1, 12)
                .mapToObj(rib -> "case_00011_rib_left_" + rib)
                .toList();
        assertThat(structures(names)).doesNotHaveDuplicates().contains("rib_01_L", "rib_12_L");
        assertThat(structures(List.of("case_3_rib_left_12", "case_3_rib_right_12")))
                .containsExactly("rib_12_L", "rib_12_R");
    }

    /** A short word for a case, which in other names is a vertebra's, is removed where organs become known by that. */
    @Test
    void aCaseMayBeCalledAsAVertebraIs() {
        assertThat(structures(List.of("S1_liver", "S1_lung_left", "S1_rib_left_5", "S1_liver_tumor", "S1_muscle")))
                .containsExactly("liver", "lung_L", "rib_05_L", "lesion_liver_tumor", "ignore");
        assertThat(structures(List.of("MR_T1_spleen", "MR_T1_kidney_left"))).containsExactly("spleen", "kidney_L");
        assertThat(structures(List.of("L4_body", "L4_spine"))).containsExactly("vertebra_L04", "-");
        assertThat(structures(List.of("L3_muscle", "L3_bone"))).containsExactly("-", "-");
    }

    /** Of two vertebrae under one label neither is a case. */
    @Test
    void vertebraeUnderOneLabelAreNotOneOfThem() {
        assertThat(structures(List.of("T5-T8"))).containsExactly("-");
        assertThat(structures(List.of("VB T5-T8"))).containsExactly("-");
        assertThat(structures(List.of("S1_liver", "S1_T5"))).containsExactly("liver", "vertebra_T05");
    }

    /** Vertebrae of a case keep their names, as do organs behind a dash or a word that is short for others. */
    @ParameterizedTest
    @CsvSource({
        "AB12_T5|AB12_T6|AB12_L1, vertebra_T05|vertebra_T06|vertebra_L01",
        "AB12_T5, vertebra_T05",
        "S3_T5|S3_T6, vertebra_T05|vertebra_T06",
        "V5 T5|V5 T6, vertebra_T05|vertebra_T06",
        "T5_A1|T6_A1, vertebra_T05|vertebra_T06",
        "AB12_vertebra_T5|AB12_vertebra_T6, vertebra_T05|vertebra_T06",
        "S1-Liver|S1-Spleen|S1-Heart|S1-Kidney_L, liver|spleen|heart|kidney_L",
        "T1-Liver|T1-Spleen|T1-Kidney_L, liver|spleen|kidney_L",
        "C1-Lung_L|C1-Lung_R|C1-Heart, lung_L|lung_R|heart",
        "L2-heart|L2-lung_left, heart|lung_L",
        "Liver-Heart|Liver-Kidney_L|Liver-Lung_R, heart|kidney_L|lung_R",
        "Heart-Lung_L|Heart-Lung_R|Heart-Liver|Heart, lung_L|lung_R|heart|heart",
        "Liver-Heart|Liver-Kidney_L|Liver-Pancreas, heart|kidney_L|pancreas",
        "Lung-Lung_L|Lung-Lung_R|Lung-Heart, lung_L|lung_R|heart",
        "Body-Lungs|Body-Heart, lungs|heart",
        "Lungs-Heart|Lungs-GTV, lungs|lungs",
        "Lungs - Heart|Lungs - GTV, lungs|lungs",
        "Liver-Spleen|Liver|Spleen, -|liver|spleen",
        "Heart-T1|Heart-T2, heart|heart",
        "Lung-Left-T1|Lung-Left-T2, lung_L|lung_L",
        "Lung-L1|Lung-L2, lungs|lungs",
        "Lung-opt1|Lung-opt2, lungs|lungs",
        "Liver-T1|Liver-T2, -|-",
        "Stomach-Body|Stomach-Fundus, -|-",
        "Heart-Muscle|Heart-Fat, heart|-",
        "Heart-table|Heart-Aorta, heart|heart",
        "Lung-Bone|Lung-Lung, lungs|lungs",
        "Liver-tumor|Liver-metastasis, lesion_liver_tumor|lesion_liver_metastasis",
        "Liver-Tumor|Liver-Liver|Liver-Vessels, lesion_liver_tumor|-|liver_vessels",
        "Liver-heart|Liver-body|Liver-lung_left, heart|skin|lung_L",
        "lung-01_liver|lung-01_spleen, liver|spleen",
        "Lung-01_heart|Lung-01_lung_left|Lung-01_GTV|Lung-01_PTV|Lung-01_CTV|Lung-01_Body, "
                + "heart|lung_L|lesion_gtv|lesion_ptv|lesion_ctv|skin",
        "Liver-Heart|Liver-Vertebrae_T5, heart|vertebra_T05",
        "Liver-Heart|Liver-Spleen|Liver-T5, heart|spleen|vertebra_T05",
        "Body-Lungs|Body-Heart|Body-T5, lungs|heart|vertebra_T05",
        "Body-Lungs|Body-Heart|Body-Liver|Tumor, lungs|heart|liver|lesion_tumor",
        "E-Lungs|E-T5|E-opt, lungs|vertebra_T05|-",
        "External-Lungs|External-Heart|Couch, lungs|heart|ignore",
        "Body-Lungs|Body-PTV|Heart, skin|skin|heart",
        "Body-Lungs|Body-Heart|Lungs, skin|heart|lungs",
        "Lesion-Liver|Lesion-Lung, lesion_lesion_liver|lesion_lesion_lung",
        "MET_001_liver|MET_001_lung_left, liver|lung_L",
        "met01_liver|met01_heart, liver|heart",
        "MET_liver|MET_heart, -|heart",
        "GTV_1_liver|GTV_1_lung, lesion_gtv_1_liver|lesion_gtv_1_lung",
        "RIB_05_L|RIB_05_R, rib_05_L|rib_05_R",
        "SEED_007_liver|SEED_007_heart, liver|heart",
        "STENT_01_liver|STENT_01_heart, liver|heart",
        "OS_001_liver|OS_001_heart, liver|heart",
        "ESO_001_liver|ESO_001_heart, liver|heart",
        "VCI_01_liver|VCI_01_heart, liver|heart",
        "NON_01_liver|NON_01_heart, liver|heart",
        "TABLE_01_liver|TABLE_01_heart, liver|heart",
    })
    void aWordThatAllNamesShareIsACase(String names, String structures) {
        assertThat(structures(List.of(names.split("\\|", -1)))).containsExactly(structures.split("\\|", -1));
    }

    /** Segments of a liver or a lung have numbers of which the first is also that of a sacral vertebra. */
    @Test
    void theFirstSegmentOfAnOrganIsNoVertebra() {
        LabelGrid grid = LabelGrid.of(3, 1, 1, new byte[] {1, 2, 3}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        assertThat(NamedLabels.of(new LabelVolume(grid, Map.of(1, "S1", 2, "S8", 3, "spleen"), List.of()))
                        .structures())
                .isEqualTo(Map.of(3, "spleen"));
        assertThat(NamedLabels.of(new LabelVolume(grid, Map.of(1, "S1", 2, "L5", 3, "spleen"), List.of()))
                        .structures())
                .containsEntry(1, "vertebra_S1");
    }

    /** A case may be left out beside margins and aids of a plan as well. */
    @Test
    void aidsOfAPlanHaveACaseAsOrgansHave() {
        assertThat(structures(List.of("S1_liver", "S1_Cord_PRV05", "S1_Ring_2cm")))
                .containsExactly("liver", "other_planning-cord_prv05", "other_planning-ring_2cm");
        assertThat(structures(List.of("Ring_1", "Ring_2")))
                .containsExactly("other_planning-ring_1", "other_planning-ring_2");
    }

    /** Rings about targets do not become the targets where all names begin with a ring. */
    @Test
    void aidsThatShareAWordStayAids() {
        assertThat(structures(List.of("RING1_PTV60", "RING1_PTV50")))
                .containsExactly("other_planning-ring1_ptv60", "other_planning-ring1_ptv50");
        assertThat(structures(List.of("case_3_RING1_PTV60", "case_3_liver")))
                .containsExactly("other_planning-ring1_ptv60", "liver");
    }

    /** The number of one structure is not taken for that of a case, by which it would be several structures or none. */
    @ParameterizedTest
    @CsvSource({
        "left costal cartilages 5, costal_cartilage_05_L",
        "ribs_left_1, rib_01_L",
        "bone_1, bone_1",
        "muscle_1, muscle_1",
        "case_3_ribs_left, ribs_L",
        "lung_left_1, lung_L",
        "00012_rib_left_1, rib_01_L",
        "Lung_L_CT1, lung_L",
    })
    void aMereNumberStaysWhereTheNameSaysLessWithoutIt(String name, String structure) {
        assertThat(structures(List.of(name))).containsExactly(structure);
    }

    /** Words that names share and that are of anatomy: side, level, and what makes of an organ something else. */
    @ParameterizedTest
    @CsvSource({
        "left_lung, left_kidney, lung_L, kidney_L",
        "rib_left_1, rib_left_12, rib_01_L, rib_12_L",
        "rib_left_1, rib_right_1, rib_01_L, rib_01_R",
        "5_rib_left, 5_rib_right, rib_05_L, rib_05_R",
        "vertebrae_T1, vertebrae_L1, vertebra_T01, vertebra_L01",
        "T5_vertebra, T5_rib_left, vertebra_T05, -",
        "liver_tumor, lung_tumor, lesion_liver_tumor, lesion_lung_tumor",
        "liver_effusion, lung_effusion, -, -",
        "liver_wall, heart_wall, -, heart",
        "liver_implant, hip_implant, -, -",
        "ptv_liver, ptv_spleen, lesion_ptv_liver, lesion_ptv_spleen",
        "cystic_artery, cystic_duct, -, -",
    })
    void wordsOfAnatomyStay(String one, String other, String ofOne, String ofOther) {
        assertThat(structures(List.of(one, other))).containsExactly(ofOne, ofOther);
    }

    @Test
    void namesOfWhichNoneBecomesKnownStayAsTheyAre() {
        assertThat(SharedWords.removed(List.of())).isEmpty();
        assertThat(SharedWords.removed(List.of("case_0001", "case_0002"))).containsExactly("case_0001", "case_0002");
        assertThat(SharedWords.removed(List.of("Label 1", "Label 2"))).containsExactly("Label 1", "Label 2");
    }

    @Test
    void aTableOfAVolumeTakesTheNamesWithoutTheCase() {
        LabelGrid grid = LabelGrid.of(3, 1, 1, new byte[] {1, 2, 3}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        LabelVolume volume = new LabelVolume(
                grid, Map.of(1, "s0011_liver", 2, "s0011_quux", 3, "s0011_spleen", 9, "absent"), List.of());
        Map<Integer, String> expected = Map.of(1, "liver", 2, "other_quux", 3, "spleen");
        assertThat(LabelGuess.of(volume).require("scan").structures()).isEqualTo(expected);
        assertThat(LabelTable.of("totalsegmentator", volume).structures()).isEqualTo(expected);
    }

    private static Map<Integer, String> sides(CageVoxels cage, boolean oneLabel) {
        Map<Integer, String> names = new TreeMap<>();
        byte[] labels = cage.labels.clone();
        for (int v = 0; v < labels.length; v++) {
            int label = labels[v] & LabelGrid.MAX_BYTE_LABEL;
            if (label > 0) {
                boolean right = label >= CageVoxels.rib(1, true);
                int own = oneLabel ? right ? 2 : 1 : label;
                names.put(own, right ? "Right rib" : "Left rib");
                labels[v] = (byte) own;
            }
        }
        LabelGrid grid = cage.volume().grid();
        return LabelGuess.of(new LabelVolume(
                        LabelGrid.of(grid.columns(), grid.rows(), grid.slices(), labels, grid.toMm()),
                        names,
                        List.of()))
                .table()
                .map(LabelTable::structures)
                .orElse(Map.of());
    }

    /** One label for the ribs of a side, or a segment for each rib without a number: the side stays known. */
    @Test
    void theRibsOfASideMayHaveTheNameOfOne() {
        assertThat(sides(new CageVoxels().withRibs(1), true)).isEqualTo(Map.of(1, "ribs_L", 2, "ribs_R"));
        assertThat(sides(new CageVoxels().withRibs(1), false)).hasSize(24).allSatisfy((label, structure) -> assertThat(
                        structure)
                .isEqualTo(label >= CageVoxels.rib(1, true) ? "ribs_R" : "ribs_L"));
        assertThat(sides(new CageVoxels().withRibs(12), true))
                .as("one rib a side")
                .isEmpty();
    }
}
