package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.virtual.VirtualThorax;

/** Names of tools, data sets, TG-263 and atlases that hold a word of another structure. */
class LabelNamesTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "celiac_trunk",
                "pulmonary_trunk",
                "external_iliac_artery_left",
                "iliac_artery_external_left",
                "External carotid artery",
                "external oblique left",
                "external_oblique_right",
                "pancreas_body",
                "stomach_body",
                "gastric body",
                "vertebrae_body",
                "body fluid",
                "thyroid_cartilage",
                "cricoid_cartilage",
                "tracheal artery",
                "manubrium of malleus",
                "lung_left_effusion",
                "left lung effusion",
                "lung_L_effusion",
                "Liver-Spleen",
                "Kidney-Liver",
                "Liver - Kidney_R",
                "Pleural effusion left lung",
                "pleura_L_effusion",
                "pneumothorax left lung",
                "left lung lymph nodes",
                "left lung artery",
                "left lung pleura",
                "pericardial_effusion",
                "pleural_effusion",
                "great cardiac vein",
                "heart fat",
                "bronchial artery",
                "cystic artery",
                "cystic duct",
                "coronary_arteries",
                "intercostal vein of rib 5 left",
                "ribbon left 5",
                "superior extremity of kidney",
                "hip_implant",
                "trunk muscles",
                "heart lead",
                "rib fracture",
                "rib_plates",
                "rib fixation",
                "sternum screws",
                "sternum wires",
                "heart stent",
                "Heart device",
                "Lung_Fiducial",
                "Lung bounding box",
                "Non_Lung",
                "Not lung",
                "Outside lung",
                "Rib-vertebra joint",
                "Rib1_L_costochondral junction",
                "L-spine",
                "T5-T8",
                "temporal lobe left",
                "thoracic vertebra",
                "cardiac stomach",
                "肺動脈",
                "肝静脉",
                "右肺积液",
                "artère poumon gauche"
            })
    void whatLiesBesideAStructureIsNotThatStructure(String name) {
        assertThat(LabelNames.structure(name)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "body, skin",
        "BODY, skin",
        "Body_trunc, skin",
        "body trunk, skin",
        "whole body, skin",
        "body outline, skin",
        "BodyContour, skin",
        "body mask, skin",
        "torso, skin",
        "BODY1, skin",
        "Body fat, skin",
        "trunk, skin",
        "EXTERNAL, skin",
        "External contour, skin",
        "patient outline, skin",
        "skin, skin",
        "Skin_05, skin",
        "Skin 5mm, skin",
        "abdominal skin, skin",
        "Peau, skin",
        "BODY-PTV, skin",
        "Body-Lungs, skin",
        "Haut, skin",
        "Körper, skin",
        "CouchSurface, ignore",
        "Couch Interior, ignore",
        "Table top, ignore",
        "E-PTV_Ev20, skin",
        "BODY_extremities, ignore",
        "lower extremity left, ignore",
    })
    void theOutlineOfABodyIsTakenByItsWholeName(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    @ParameterizedTest
    @CsvSource({
        "Lungs-GTV, lungs",
        "Lungs-GTVp, lungs",
        "Lungs-IGTV, lungs",
        "Lung_L-GTV, lung_L",
        "Lung_R-PTV_6000, lung_R",
        "Liver-GTV, liver",
        "Liver-CTV, liver",
        "Liver - ITV, liver",
        "Heart-PTV, heart",
        "Kidney_R-PTV, kidney_R",
        "liver without tumor, liver",
        "lung_left_minus_gtv, lung_L",
        "Lungs_NOT_GTV, lungs",
        "LungsNOTGTV, lungs",
        "Lungs less GTV, lungs",
        "Lungs-(ITV), lungs",
        "Lung_R_nonPTV, lung_R",
        "Lungs w/o GTV, lungs",
        "Liver_noGTV, liver",
        "LiverMinusGTV, liver",
        "Liver-Heart, liver",
        "Lung_L-Heart, lung_L",
        "Heart-Lungs, heart",
        "Heart-Lung_L, lung_L",
        "left lung-heart, lung_L",
        "External-Lungs, skin",
        "Colon - liver metastasis, lesion_colon_liver_metastasis",
        "Kidney_L - lung metastasis, lesion_kidney_lung_metastasis_L",
        "T10 - lung tumor, lesion_t10_lung_tumor",
        "Rib_5_L-Lung-Tumor, lesion_rib_5_lung_tumor_L",
        "Body-Lung-Tumor, lesion_body_lung_tumor",
        "Chest wall - lung tumor, lesion_chest_wall_lung_tumor",
        "Lesion-Liver, lesion_lesion_liver",
        "Lesion-CTV, lesion_lesion_ctv",
        "Body-Lung_L, lung_L",
        "Torso-Heart, heart",
        "Skeleton-Heart, heart",
        "Spine-Lung, lungs",
        "C1-Heart, heart",
        "Lung-Lung_L, lung_L",
        "bone_opt, bone_skeleton",
        "bone_without_tumor, bone_skeleton",
        "rib no 5 left, rib_05_L",
        "lung-trachea-bronchia, trachea",
    })
    void anOrganLessItsTargetIsTheOrgan(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    @ParameterizedTest
    @CsvSource({
        "lung_L_tumor, lesion_lung_tumor_L",
        "lung_R_tumor, lesion_lung_tumor_R",
        "lung_L_nodule, lesion_lung_nodule_L",
        "Lung_L_GTV, lesion_lung_gtv_L",
        "left lung cancer, lesion_lung_cancer_L",
        "Lung mass right, lesion_lung_mass_R",
        "sternum_metastasis, lesion_sternum_metastasis",
        "skin_lesion, lesion_skin_lesion",
        "rib 5 left metastasis, lesion_rib_5_metastasis_L",
        "liver_cysts, lesion_liver_cysts",
        "IGTV, lesion_igtv",
        "Planning Target Volume, lesion_planning_target_volume",
        "Liver_GTV, lesion_liver_gtv",
        "GTV-CTV, lesion_gtv_ctv",
        "liver_tumor, lesion_liver_tumor",
        "kidney_cyst_left, kidney_cyst_L",
        "Lung_Met_L, lesion_lung_met_L",
        "Liver mets, lesion_liver_mets",
        "rib 5 left met, lesion_rib_5_met_L",
        "Tumeur d'estomac, lesion_tumor_d_stomach",
        "tumeur d’un rein gauche, lesion_tumor_d_un_kidney_L",
        "mesothelioma left lung, lesion_mesothelioma_lung_L",
        "Lung granuloma, lesion_lung_granuloma",
        "hepatoblastoma, lesion_hepatoblastoma",
        "右肺癌, lesion_lung_cancer_R",
    })
    void aLesionIsNotTheOrganAboutIt(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** Margins and aids of a plan of radiotherapy, which are neither obstacles nor lesions. */
    @ParameterizedTest
    @CsvSource({
        "Skin_PRV05, skin_prv05",
        "Lung_L_PRV05, lung_prv05_L",
        "SpinalCord_PRV05, spinal_cord_prv05",
        "PRV of spinal cord, prv_of_spinal_cord",
        "SpinalCord_PRV5mm, spinal_cord_prv5mm",
        "PRV5mm_Cord, prv5mm_cord",
        "cordprv, cordprv",
        "SpinalCordPRV, spinal_cord_prv",
        "LungPRV05_L, lung_prv05_L",
        "PTV_60_Ring, ptv_60_ring",
        "PTV_High_Ring, ptv_high_ring",
        "Ring_High, ring_high",
        "Ring_Liver, ring_liver",
        "Liver_Ring, liver_ring",
        "Liver_Ring_2cm, liver_ring_2cm",
        "Ring_2cm_Liver, ring_2cm_liver",
        "zRing_Lungs, z_ring_lungs",
        "Ring_Lung_L, ring_lung_L",
        "Lung_L_Ring, lung_ring_L",
        "Heart Ring, heart_ring",
        "Liver_GTV_Ring, liver_gtv_ring",
        "other_planning-ptv_60_ring, ptv_60_ring",
        "Ring, ring",
        "Ring_2cm, ring_2cm",
        "Ring_PTV, ring_ptv",
        "PTV_Ring_2cm, ptv_ring_2cm",
        "Ring inner, ring_inner",
        "zRing1, z_ring1",
        "z_Aid, z_aid",
        "opt_1, opt_1",
        "zOpt, z_opt",
        "Dose, dose",
        "Dose 95[%], dose_95",
        "95% dose, 95_dose",
        "Dose_GTV, dose_gtv",
        "Isodose_50Gy, isodose_50gy",
        "50 % isodose, 50_isodose",
        "Shell_2cm, shell_2cm",
        "PTV_Shell, ptv_shell",
        "Lung_L_Shell, lung_shell_L",
        "NS_Ring1, ns_ring1",
        "Avoid, avoid",
        "Hotspot, hotspot",
        "Chestwall-Lung, chestwall",
        "CW-Lung, cw_lung",
        "Thoracic wall, thoracic_wall",
        "Brustwand links, chest_wall_L",
        "Chestwall_R, chestwall_R",
        "Chest wall left, chest_wall_L",
        "Chestwall3cm, chestwall3cm",
        "CW2cm, cw2cm",
        "CW_2cm, cw_2cm",
    })
    void anAidOfAPlanIsNoPartOfABody(String name, String words) {
        String structure = "other_planning-" + words;
        assertThat(LabelNames.structure(name)).contains(structure);
        assertThat(LabelTable.isOfPlan(structure)).isTrue();
        assertThat(LabelTable.isStructure(structure)).isTrue();
    }

    @ParameterizedTest
    @CsvSource({
        "trachea ring, trachea",
        "ring enhancing lesion, lesion_ring_enhancing_lesion",
        "ring-enhancing liver lesion, lesion_ring_enhancing_liver_lesion",
    })
    void aRingThatIsNoAidKeepsItsName(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** A name that is unknown stays that of an obstacle whatever it begins with. */
    @ParameterizedTest
    @ValueSource(strings = {"Planning bolus", "planning_liver", "other_planning_x", "Planning-Bolus"})
    void anUnknownNameIsNoAidOfAPlan(String name) {
        assertThat(LabelNames.structure(name).filter(LabelTable::isOfPlan)).isEmpty();
        assertThat(LabelTable.isOfPlan(OrganNames.other(name, 1))).isFalse();
    }

    @ParameterizedTest
    @CsvSource({
        "Liver_opt, liver",
        "zLung_L_opt, lung_L",
        "Spleen_opt1, spleen",
        "opt Heart, heart",
        "Kidney_opt_L, kidney_L",
        "PTV_opt, lesion_ptv_opt",
        "zPTV_60, lesion_z_ptv_60",
        "low_dose_lung_left, lung_L",
        "low_dose_rib_left_5, rib_05_L",
        "low_dose_heart, heart",
        "LowDose_Lung_L, lung_L",
        "Dose_Heart, heart",
        "PTV_low_dose, lesion_ptv_low_dose",
    })
    void aWordOfAPlanLeavesAnOrganOrATargetAsItIs(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "opt_nerve_L",
                "nerve_opt_L",
                "Opt_N_L",
                "OptN_R",
                "opt_ns",
                "Opt_Disc_L",
                "Opt. radiation",
                "opt_T1",
                "Z line",
                "Z_line",
                "mitral ring",
                "Ring_mitral",
                "ring implant",
                "Ring pessary",
                "ring catheter",
                "ringer",
                "z1",
                "chest wall muscles",
                "CW",
                "overdosed",
                "low dose spleen"
            })
    void whatOnlySharesAWordWithAPlanIsUnknown(String name) {
        assertThat(LabelNames.structure(name)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "Rib cartilage 3 left, costal_cartilage_03_L",
        "left costal cartilage of rib 3, costal_cartilage_03_L",
        "Left fifth costal cartilage, costal_cartilage_05_L",
        "Costal cartilage 3 L, costal_cartilage_03_L",
        "Rippenknorpel, costal_cartilages",
        "cartilage, costal_cartilages",
        "Right third rib, rib_03_R",
        "5th rib left, rib_05_L",
        "ribcage, ribs",
        "Vertebral body T5, vertebra_T05",
        "corpus_vertebrae_T5, vertebra_T05",
        "sternum_body, sternum_body",
        "sternal body, sternum_body",
        "body of sternum, sternum",
        "lung opacity left, lung_L",
        "Linker unterer Lungenlappen, lung_L",
        "Lungenvene rechts, pulmonary_vein_R",
        "BWK_5, vertebra_T05",
        "Wirbel_BWK-5, vertebra_T05",
        "LWK_1, vertebra_L01",
        "肝右叶, liver",
        "右肺上叶, lung_R",
        "肝实质, liver",
        "肝血管瘤, lesion_liver_hemangioma",
        "Lungenrundherd rechts, lesion_lung_nodule_R",
        "left lung atelectasis, lung_L",
        "lower lobe of left lung, lung_L",
        "Lung_LUL, lung_L",
        "Lung_RML, lung_R",
        "lung_pleural, lungs",
        "Left lung vessels, lung_L",
        "right lobe of liver, liver",
        "Liver segment 5, liver",
        "heart_myocardium, heart",
        "heart_atrium_left, heart",
        "Left ventricle of heart, heart",
        "pulmonary_artery, pulmonary_artery",
        "portal vein, portal_vein",
        "左肾上腺, adrenal_gland_L",
        "pleura_L, pleura_L",
        "lung_R_middle, lung_R_middle",
        "left upper lobe, lung_L",
        "RightMiddleLobe, lung_R",
        "LUL, lung_L",
        "RLL, lung_R",
        "ribs_left, ribs_L",
        "left costal cartilages, costal_cartilages",
        "T 12, vertebra_T12",
        "T-12, vertebra_T12",
        "Th12, vertebra_T12",
        "12th thoracic vertebra, vertebra_T12",
        "first lumbar vertebra, vertebra_L01",
        "vertebra_T1, vertebra_T01",
        "vertebra_L1, vertebra_L01",
        "rib_1_L, rib_01_L",
        "Rib_5_r, rib_05_R",
        "costal_cartilage_5_R, costal_cartilage_05_R",
    })
    void partsAndOtherOrdersOfWordsAreKnown(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** What lies in or beside an organ is not the organ. */
    @ParameterizedTest
    @CsvSource({
        "肺门淋巴结",
        "胃周淋巴结",
        "肋骨骨折",
        "肝内胆管",
        "锁骨_L",
        "左锁骨L",
        "股骨_R",
        "左股骨 (L)",
        "肩胛骨_R",
        "骨盆_L",
        "骨髓_R",
        "软骨_L",
        "腎盂_L",
        "骨盆_mask",
        "Lungenhilus",
        "Lungenembolie"
    })
    void aNameWithAnUnknownWordIsNoOrgan(String name) {
        assertThat(LabelNames.structure(name)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "hepatic veins, hepatic_vein",
        "Hepatic_Veins, hepatic_vein",
        "pulmonary veins, pulmonary_vein",
        "pulmonary_arteries, pulmonary_artery",
        "left iliac arteries, iliac_artery_L",
        "SVC, superior_vena_cava",
        "Vena cava inferior, inferior_vena_cava",
        "vena_cava_superior, superior_vena_cava",
        "large_intestine, colon",
        "Large Intestine, colon",
        "both kidneys, organ_kidneys",
        "liver_mask, liver",
        "Liver Segmentation, liver",
        "mask_spleen, spleen",
        "aorta_seg, aorta",
        "T5_seg, vertebra_T05",
        "kidney_left_mask, kidney_L",
        "left deep back muscle, autochthon_L",
        "right common iliac artery, iliac_artery_R",
        "left common iliac vein, iliac_vein_L",
        "kidneys_left, kidney_L",
        "kidney_left_total, kidney_L",
        "Total Kidney Left, kidney_L",
        "Kidney_total_L, kidney_L",
        "Kidneys total, organ_kidneys",
        "LLung, lung_L",
        "RKidney, kidney_R",
        "Rib5Left, rib_05_L",
        "Kidney_L_AI, kidney_L",
        "Spleen contour, spleen",
        "Liver remnant, liver",
        "Future liver remnant, liver",
        "Liver S4, liver",
        "Liver_Seg_5, liver",
        "Thyroid_L, thyroid_gland_L",
        "Glnd_Adrenal_L, adrenal_gland_L",
        "leftsurrenalgland, adrenal_gland_L",
        "smallintestin, small_bowel",
        "Cord, spinal_cord",
        "Eso, oesophagus",
        "Spinal column, bone_spine",
        "vertebra D5, vertebra_T05",
        "vertèbre D 10, vertebra_T10",
        "vertèbres D10, vertebra_T10",
        "Spine R, bone_spine",
        "Lung L non-contrast, lung_L",
        "Lung_R (no contrast), lung_R",
        "Heart_non_gated, heart",
        "rib_left_5_non_displaced, rib_05_L",
        "Rib 5 L not complete, rib_05_L",
        "ribs non-floating left, ribs_L",
        "Skin_Outside, skin",
        "sternum non union, sternum_non_union",
        "lung distention left, lung_L",
        "persistent heart, heart",
        "Lung (consistent), lungs",
    })
    void pluralsAndCommonSpellingsAreKnown(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** Of several structures under one label none is the others; pairs are known, and bones are told apart. */
    @ParameterizedTest
    @CsvSource({
        "Lung_L+Lung_R, lungs",
        "left kidney and right kidney, organ_kidneys",
        "Rib cage and spine, bone_skeleton",
        "rib 5 & rib 6 left, ribs_L",
        "right rib 5 and left rib 5, ribs",
        "Rib and cartilage, costal_cartilages",
        "Rib 5 left and cartilage, costal_cartilage_05_L",
        "ribs and scapula, ribs",
        "ribs and T5, bone_skeleton",
        "Skin and muscle, skin",
        "Skin and muscles, skin",
        "Ribs+Sternum, ribs",
        "Sternum and ribs, ribs",
        "Heart+Pericardium, heart",
        "Heart+A_Pulm, heart",
        "Lungs+Heart, -",
        "Aorta+Heart, -",
        "Costal cartilages and sternum, -",
        "Spleen & stomach, -",
        "Liver+GTV, lesion_liver_gtv",
        "portal_vein_and_splenic_vein, portal_and_splenic_vein",
    })
    void severalStructuresUnderOneLabelAreNotOneOfThem(String name, String structure) {
        assertThat(LabelNames.structure(name).orElse("-")).isEqualTo(structure);
    }

    /** Vessels in the order of words of TG-263 and of other languages, and parts of the aorta. */
    @ParameterizedTest
    @CsvSource({
        "V_Portal, portal_vein",
        "V. portae, portal_vein",
        "V_Hepatic, hepatic_vein",
        "A_Pulmonary, pulmonary_artery",
        "V_Pulmonary, pulmonary_vein",
        "A_Subclavian_L, subclavian_artery_L",
        "RHV, hepatic_vein_R",
        "Middle hepatic vein, hepatic_vein",
        "V. cava inferior, inferior_vena_cava",
        "Vena cava sup, superior_vena_cava",
        "Inf. vena cava, inferior_vena_cava",
        "VCI, inferior_vena_cava",
        "Ascending aorta, aorta",
        "Aortic arch, aorta",
        "A_Aorta_Asc, aorta",
        "aorta_abdominal, aorta",
    })
    void vesselsAreKnownByWordsInOtherOrders(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** Names of tables that hold capitals, and the vertebrae that some people have beyond the usual number. */
    @ParameterizedTest
    @CsvSource({
        "vertebrae_L6, bone_vertebra_L6",
        "vertebra L6, bone_vertebra_L6",
        "L6, bone_vertebra_L6",
        "bone_vertebra_L6, bone_vertebra_L6",
        "vertebra T13, bone_vertebra_T13",
        "vertebrae_T13, bone_vertebra_T13",
        "IVD, other_intervertebral_discs",
        "vertebrae_S1, vertebra_S1",
        "cervical rib, bone_cervical_rib",
        "Left cervical rib, bone_cervical_rib_L",
        "cervical_rib_right, bone_cervical_rib_R",
        "rib_cervical_left_1, bone_cervical_rib_L",
        "cervical rib 7 right, bone_cervical_rib_R",
        "Halsrippe links, bone_cervical_rib_L",
        "lumbar rib left, bone_lumbar_rib_L",
    })
    void namesOfToolsWithCapitalsAreKnown(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    @ParameterizedTest
    @CsvSource({
        "ribs 1-12 left, ribs_L",
        "Ribs 1 to 12 right, ribs_R",
        "rib 1-12 left, ribs_L",
        "rib_1-12_left, ribs_L",
        "rib 1 to 12 left, ribs_L",
        "rib 1-12L, ribs_L",
        "Rib 11 & 12 left, ribs_L",
        "Rib 5+6 left, ribs_L",
        "ribs 5 and 6 left, ribs_L",
        "Rippen 1 bis 12 rechts, ribs_R",
        "ribs 1-12, ribs",
        "costal cartilages 1-7 left, costal_cartilages",
    })
    void aRangeOfNumbersIsNoSingleRib(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    @ParameterizedTest
    @CsvSource({
        "Rib L5, rib_05_L",
        "Rib R5, rib_05_R",
        "rib5L, rib_05_L",
        "rib 12R, rib_12_R",
        "Rippe 5 li, rib_05_L",
        "Rippe re. 7, rib_07_R",
        "rib_5_left_2, rib_05_L",
        "rib_1_left_2, rib_01_L",
        "rib_01_R_2, rib_01_R",
        "rib 1 (left) 2, rib_01_L",
        "costal cartilage 1 left 2, costal_cartilage_01_L",
        "ribs_re-segmented, ribs",
        "ribs (re-seg), ribs",
        "ribs_r1, ribs",
        "ribcage R2, ribs",
        "L1 rib, ribs",
        "lumbar rib L1, bone_lumbar_rib",
    })
    void aSideMayBeALetterBesideTheNumberOfARib(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** An abbreviation of a side is one beside a word of its language alone. */
    @ParameterizedTest
    @CsvSource({
        "Lunge li, lung_L",
        "Re. Lunge, lung_R",
        "Niere re., kidney_R",
        "polmone dx, lung_R",
        "polmone sx, lung_L",
        "rene sn, kidney_L",
        "Costa 7 sin, rib_07_L",
        "poumon g, lung_L",
        "côte 5 D, rib_05_R",
        "vertèbre D5, vertebra_T05",
        "poumon d'un patient, lungs",
        "2ème côte gauche, rib_02_L",
        "1ère côte D, rib_01_R",
        "5e côte G, rib_05_L",
        "1er côte G, rib_01_L",
        "5a costa sx, rib_05_L",
        "V costa sx, rib_05_L",
        "XII costa sx, rib_12_L",
        "Costa I dx, rib_01_R",
        "costae I-XII sin, ribs_L",
        "pulmón izq., lung_L",
        "riñón der, kidney_R",
        "pulmão dir, lung_R",
        "pulmo dex, lung_R",
        "lung_re, lungs",
        "lung re-segmented, lungs",
        "lung dx, lungs",
        "poumon li, lungs",
        "Patient_D_poumon gauche, lung_L",
        "G_01_poumon droit, lung_R",
        "côte 5 gauche D, rib_05_L",
        "CT_re_Lunge links, lung_L",
        "CT_re_Rippe 5 links, rib_05_L",
        "pulmón der izquierdo, lung_L",
    })
    void aSideMayBeAbbreviatedBesideAWordOfItsLanguage(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    @ParameterizedTest
    @ValueSource(strings = {"ascites", "Aszites", "Ascite", "腹水", "free fluid abdomen", "peritoneal fluid"})
    void fluidOfTheAbdomenIsAscites(String name) {
        assertThat(LabelNames.structure(name)).contains("other_ascites");
    }

    /** Drains, and fluid that may lie in the chest. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "ascites drain",
                "free fluid",
                "thoracoabdominal fluid",
                "R5",
                "5L",
                "D5",
                "liver re",
                "rib 5a left",
                "Rib I-XII left",
                "OS",
                "T1_label",
                "T1 volume",
                "T1_ROI",
                "T2_auto",
                "volume_S1",
                "label_L1",
                "T1 contour"
            })
    void whatMayBeElsewhereIsUnknown(String name) {
        assertThat(LabelNames.structure(name)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "胰腺 Pancreas, pancreas",
        "十二指肠 Duodenum, duodenum",
        "膀胱 urinary_bladder, urinary_bladder",
        "甲状腺 Thyroid gland, thyroid_gland",
        "脊髓 Spinal cord, spinal_cord",
        "脊髓 SpinalCord, spinal_cord",
        "脊柱 Spine, bone_spine",
        "骨骼肌 Skeletal muscle, muscle_skeletal",
        "骨格筋_muscles, muscle_skeletal",
        "肩胛骨 Scapula_L, scapula_L",
        "左股骨 Femur, femur_L",
        "颅骨 skull, skull",
        "肝脏 Liver, liver",
        "左肺 Lung, lung_L",
        "肋骨 5 left, rib_05_L",
        "胸椎 T5, vertebra_T05",
        "肝 S1, liver",
        "肺癌 Lung, lesion_lung_cancer_lung",
        "下腔静脉 IVC, inferior_vena_cava",
        "肾 Kidneys, organ_kidneys",
        "腹水 Liver, other_ascites",
        "肝-GTV, liver",
        "Lung_L_左肺, lung_L",
        "左肺 opt, lung_L",
        "肝脏OPT, liver",
        "左肾 opt, kidney_L",
        "左肺 avoid, lung_L",
        "肝 avoid, liver",
        "心脏 PRV, other_planning-heart_prv",
        "肝 ring, other_planning-liver_ring",
        "左肺_Body, lung_L",
        "Body_肝脏, liver",
        "左肺 External, lung_L",
        "左肺_COR, lung_L",
        "肝脏_COR, liver",
        "胸骨 Bone, sternum",
        "肋骨_Bone, ribs",
        "左肺_Bone, lung_L",
        "Bone_左肋骨5, rib_05_L",
        "脊柱 T5, vertebra_T05",
        "骶骨 Sacrum, sacrum",
        "骨 Femur_L, femur_L",
        "小肠 Bowel, small_bowel",
        "胸骨 Manubrium, sternum_manubrium",
        "右肺 bronchus, trachea",
        "肋骨 cartilage, costal_cartilages",
        "T5椎体, vertebra_T05",
        "第5肋骨 Rib 5 L, rib_05_L",
        "左肺 Lung 张三, lung_L",
        "张三 肝脏 Liver, liver",
        "LUNG1-001_心脏, heart",
        "LUNG_001_肝脏, liver",
        "骨转移 Bone met, lesion_bone_bone_met",
        "上腕骨 Humerus, humerus",
        "胸椎 Spine, bone_spine",
        "肺 Lunge links, lung_L",
        "肾 Niere links, kidney_L",
        "右腎臟 Kidney_R, kidney_R",
        "腎上腺 Adrenal_L, adrenal_gland_L",
        "左侧肺 Lung, lung_L",
        "子宫 Uterus, uterus",
        "体表 Body, skin",
    })
    void aNameInTwoScriptsIsTakenByThePartThatSaysMore(String name, String structure) {
        assertThat(LabelNames.structure(name)).contains(structure);
    }

    /** Either part is of one structure, and not of the same, or the ideographs say more than is known. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "胆囊 Liver",
                "肝靶区 Liver",
                "胆管 Liver",
                "肾上腺 Kidney_L",
                "食管 Stomach",
                "胃窦 Stomach",
                "肝门 Liver",
                "肝 Heart",
                "右肺积液 Lung",
                "大脑_COR",
                "S1段"
            })
    void aNameInTwoScriptsThatSayOtherThingsIsUnknown(String name) {
        assertThat(LabelNames.structure(name)).isEmpty();
    }

    /** The name of a structure that holds words of others. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "Liver and Spleen",
                "Heart + Lungs",
                "ribs_and_scapula",
                "pacemaker lead",
                "sternum wire",
                "Lungs-GTV",
                "liver opt",
                "lungs minus gtv",
                "stomach without tumor",
                "lung tumor",
                "no lung",
                "ring liver"
            })
    void aWrittenNameStandsForItself(String words) {
        String other = OrganNames.other(words, 1);
        String bone = other.replace("other_", "bone_");
        assertThat(LabelNames.structure(other)).contains(other);
        assertThat(LabelNames.structure(bone)).contains(bone);
    }

    /** A folder of meshes that Phrenic has written keeps its structures. */
    @Test
    void theNameOfAStructureStandsForIt() {
        Stream<String> ofTables = NumberTable.ALL.stream().flatMap(table -> table.structures().values().stream());
        Stream<String> ofBody = VirtualThorax.ofPreset("adult-male", Resolution.LOW).structures().stream()
                .map(Structure::name);
        assertThat(Stream.concat(ofTables, ofBody))
                .allSatisfy(name -> assertThat(LabelNames.structure(name).flatMap(StructureName::parse))
                        .isEqualTo(StructureName.parse(name)));
    }
}
