package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;

/** Names of unknown structures in a body without lungs. */
class ChestContentsTest {
    private static boolean isInChest(String name) {
        Structure s = new Structure(name, StructureKind.OTHER, 0, Side.MIDLINE, Shapes.sphere(10, 1));
        return new ChestContents(List.of(s)).has(s);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "other_pleural_effusion",
                "other_fluid_pleural_R",
                "other_Pneumothorax",
                "other_empyema",
                "other_tuberculous_effusion",
                "other_pleural_air",
                "other_Pleuraerguss"
            })
    void fluidAndAirInThePleuraGoWithTheLungs(String name) {
        assertThat(isInChest(name)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "other_pleural_drain",
                "other_pneumothorax_catheter",
                "other_effusion_tube",
                "other_pleural_plaque",
                "other_pleural_thickening_effusion",
                "other_pleura_parietal",
                "other_pericardial_effusion",
                "other_Perikarderguss",
                "other_drain_of_effusion"
            })
    void drainsAndWhatLiesOnTheWallStay(String name) {
        assertThat(isInChest(name)).isFalse();
    }
}
