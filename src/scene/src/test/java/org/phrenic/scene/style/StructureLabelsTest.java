package org.phrenic.scene.style;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.scene.camera.PickResult;

class StructureLabelsTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "rib_05_R | Rib 5 right",
                "costal_cartilage_02_L | Costal cartilage 2 left",
                "vertebra_T06 | Vertebra T6",
                "vertebra_L1 | Vertebra L1",
                "vertebra_C7 | Vertebra C7",
                "vertebra_S1 | Vertebra S1",
                "disc_T12_L1 | Disc T12-L1",
                "disc_L5_S1 | Disc L5-S1",
                "disc_C7_T1 | Disc C7-T1",
                "lung_R | Lung right",
                "lung_L_upper | Lung left, upper lobe",
                "lung_R_2 | Lung right, piece 2",
                "lung_R_upper_2 | Lung right, upper lobe, piece 2",
                "lung_R_middle_2 | Lung right, middle lobe, piece 2",
                "lung_R_segment_10 | Lung right, segment 10",
                "sternum_body | Sternum body",
                "diaphragm | Diaphragm",
                "liver | Liver",
                "skin_torso | Skin",
                "skin_2 | Skin, piece 2",
                "my_tumour | My tumour"
            })
    void structuresAreCalledAsPeopleCallThem(String name, String expected) {
        assertThat(StructureLabels.of(name)).isEqualTo(expected);
    }

    @Test
    void aPlaceIsToldByTheSidesOfTheBody() {
        assertThat(PickResult.positionText(-42.2, 11.9, 130.4)).isEqualTo("R 42 P 12 S 130 mm");
        assertThat(PickResult.positionText(3, -4, -5)).isEqualTo("L 3 A 4 I 5 mm");
        assertThat(PickResult.positionText(-0.2, 0.2, 0)).isEqualTo("L 0 P 0 S 0 mm");
    }
}
