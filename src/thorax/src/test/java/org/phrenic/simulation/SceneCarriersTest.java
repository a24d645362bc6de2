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
                "lesion_sternum_metastasis",
                "lesion_rib_5_metastasis_l",
                "lesion_vertebra_t12_tumor",
                "lesion_bone_metastases",
            })
    void aLesionOfABoneGoesWithTheBones(String name) {
        assertThat(SceneCarriers.isInLiver(name)).isFalse();
        assertThat(LesionPlace.isInBone(name)).isTrue();
    }
}
