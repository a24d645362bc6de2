package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.LesionPlace;

/** What carries lesions and vessels, by their names in lower case. */
class SceneCarriersTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "lesion_liver_tumor",
                "liver_tumor",
                "tumor",
                "lesion",
                "lesion_2",
                "lesion_gtv",
                "lesion_igtv_ctv",
                "lesion_hcc",
                "lesion_lymphoma",
                "lesion_portal_vein",
                "lesion_colon_liver_metastasis",
                "hepatic_vein",
                "vessel_hepatic_vein_middle",
                "portal_vein_l",
                "liver_vessels",
            })
    void whatLiesInTheLiverGoesWithIt(String name) {
        assertThat(SceneCarriers.isInLiver(name)).isTrue();
        assertThat(LesionPlace.isInBone(name)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "lesion_colon_cancer",
                "lesion_lung_nodule_l",
                "lesion_lungtumor",
                "lesion_bronchial_cancer",
                "lesion_kidney_tumor_r",
                "lesion_pancreatic_tumor",
                "lesion_adrenal_gland_r",
                "lesion_spleen_cysts",
                "lesion_lymph_node_metastasis",
                "lesion_heart_tumor",
                "lesion_skin_lesion",
                "lesion_oesophagus_gtv",
                "lesion_aorta",
                "lesion_iliopsoas_l",
                "lesion_autochthon_r",
                "lesion_abdominal_wall",
                "lesion_thymus",
                "lesion_tracheal",
                "lesion_ureter",
                "lesion_lymphnode",
                "lesion_peritoneum",
                "lesion_appendix",
                "lesion_inferior_vena_cava",
                "lesion_gluteus_maximus_l",
                "lesion_splenic_vein",
                "portal_vein",
                "kidney_cyst_r",
            })
    void aLesionOfAnotherOrganDoesNot(String name) {
        assertThat(SceneCarriers.isInLiver(name)).isFalse();
        assertThat(LesionPlace.isInBone(name)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "lesion_bone_lesion",
                "lesion_chest_wall",
                "lesion_sternum_metastasis",
                "lesion_rib_5_metastasis_l",
                "lesion_vertebra_t12_tumor",
                "lesion_bone_metastases",
            })
    void aLesionOfABoneGoesWithTheBones(String name) {
        assertThat(SceneCarriers.isInLiver(name)).isFalse();
        assertThat(LesionPlace.isInBone(name)).isTrue();
        assertThat(LesionPlace.mayBeInCage(name)).as("of what the ribs carry").isEqualTo(!name.contains("vertebra"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "lesion_aorta",
                "lesion_aortic_tumor",
                "lesion_oesophagus_gtv",
                "lesion_iliopsoas_l",
                "lesion_muscle",
                "lesion_paraspinal_muscle_r",
                "lesion_gluteal_muscles_l",
                "lesion_iliac_artery_r",
                "lesion_autochthon_r",
                "lesion_abdominal_wall",
            })
    void aLesionOfWhatABreathDoesNotMoveStandsStill(String name) {
        assertThat(LesionPlace.standsStill(name)).isTrue();
        assertThat(SceneCarriers.isInLiver(name)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "lesion_liver_tumor",
                "lesion_kidney_tumor_r",
                "lesion_lung_aorta",
                "lesion_pulmonary_nodule",
                "lesion_rib_5_metastasis_l",
                "lesion_inferior_vena_cava",
                "aorta",
            })
    void aLesionOfWhatMovesDoesNotStandStill(String name) {
        assertThat(LesionPlace.standsStill(name)).isFalse();
    }
}
