package org.phrenic.anatomy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.file.FileNames;

class StructureNameTest {
    @ParameterizedTest
    @CsvSource({
        "rib_05_R, RIB, 5, RIGHT",
        "Rib_5_r, RIB, 5, RIGHT",
        "rib_12_L, RIB, 12, LEFT",
        "costal_cartilage_02_L, COSTAL_CARTILAGE, 2, LEFT",
        "sternum_body, STERNUM, 0, MIDLINE",
        "vertebra_T06, VERTEBRA, 6, MIDLINE",
        "vertebra_L1, VERTEBRA, 13, MIDLINE",
        "vertebra_L05, VERTEBRA, 17, MIDLINE",
        "disc_C7_T1, DISC, 0, MIDLINE",
        "disc_T4_T5, DISC, 4, MIDLINE",
        "disc_T12_L1, DISC, 12, MIDLINE",
        "lung_R_middle, LUNG, 0, RIGHT",
        "lung_L, LUNG, 0, LEFT",
        "diaphragm, DIAPHRAGM, 0, MIDLINE",
        "liver, LIVER, 0, MIDLINE",
        "skin_torso, SKIN, 0, MIDLINE",
        "heart, ORGAN, 0, MIDLINE",
        "kidney_R, ORGAN, 0, RIGHT",
        "Adrenal_Gland_l, ORGAN, 0, LEFT",
        "inferior_vena_cava, VESSEL, 0, MIDLINE",
        "iliopsoas_L, MUSCLE, 0, LEFT",
        "vertebra_C7, BONE, 0, MIDLINE",
        "liver_tumor, LESION, 0, MIDLINE",
        "vessel_left_gastric_artery, VESSEL, 0, MIDLINE",
        "other_150, OTHER, 0, MIDLINE",
        "trachea, OTHER, 0, MIDLINE",
    })
    void aNameSaysWhatTheStructureIs(String name, StructureKind kind, int level, Side side) {
        assertThat(StructureName.parse(name)).contains(new StructureName(kind, level, side));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "rib_00_R",
                "rib_13_L",
                "costal_cartilage_11_L",
                "vertebra_T13",
                "vertebra_T00",
                "vertebra_L0",
                "vertebra_L06",
                "disc_C6_C7",
                "rib_05",
                "blob",
                "diaphragm_old",
                "other_",
                "lung_R_a:b",
                "skin/../../x",
                "sternum?",
                ""
            })
    void whatNoBodyHasIsNoName(String name) {
        assertThat(StructureName.parse(name)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "Liver Tumour #2, other_liver_tumour_2",
        "150, other_150",
        "--, other_7",
        "'', other_7",
        // In place of a letter and an accent of its own, as macOS writes names, the letter with its accent.
        "La\u0308sion (gro\u00df), other_l\u00e4sion_gro\u00df",
        // Cyrillic, Greek, Arabic, Hebrew and Korean.
        "\u0421\u0435\u0440\u0434\u0446\u0435, other_\u0441\u0435\u0440\u0434\u0446\u0435",
        "\u039a\u03b1\u03c1\u03b4\u03b9\u03ac 2, other_\u03ba\u03b1\u03c1\u03b4\u03b9\u03ac_2",
        "\u0642\u0644\u0628, other_\u0642\u0644\u0628",
        "\u05dc\u05d1, other_\u05dc\u05d1",
        "\uc2ec\uc7a5, other_\uc2ec\uc7a5"
    })
    void anyTextMakesTheNameOfAnObstacle(String text, String name) {
        assertThat(OrganNames.other(text, 7)).isEqualTo(FileNames.isOfSystem(name) ? name : "other_7");
        assertThat(StructureName.parse(name)).contains(new StructureName(StructureKind.OTHER, 0, Side.MIDLINE));
    }

    @ParameterizedTest
    @CsvSource({
        "rib_1_L, rib_01_L",
        "Rib_12_r, rib_12_R",
        "rib_005_R, rib_05_R",
        "costal_cartilage_5_R, costal_cartilage_05_R",
        "vertebra_T1, vertebra_T01",
        "VERTEBRA_t12, vertebra_T12",
        "vertebra_L1, vertebra_L01",
        "vertebra_c7, vertebra_C7",
        "disc_t04_T05, disc_T4_T5",
        "disc_T9_T10, disc_T9_T10",
        "Lung_r_Middle, lung_R_middle",
        "Liver, liver",
        "kidney_l, kidney_L",
        "bone_vertebra_l6, bone_vertebra_L6",
        "no name, no name",
    })
    void aNameHasOneUsualSpelling(String name, String usual) {
        assertThat(StructureName.usual(name)).isEqualTo(usual);
    }

    @Test
    void theNamesOfTheVirtualBodySayWhatItsStructuresAre() {
        assertThat(VirtualThorax.ofPreset("adult-male", Resolution.LOW).structures())
                .allSatisfy(s -> assertThat(StructureName.parse(s.name()))
                        .as(s.name())
                        .contains(new StructureName(s.kind(), s.level(), s.side())))
                .allSatisfy(s -> assertThat(StructureName.usual(s.name())).isEqualTo(s.name()));
    }
}
