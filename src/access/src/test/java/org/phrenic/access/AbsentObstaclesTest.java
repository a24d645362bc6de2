package org.phrenic.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;

class AbsentObstaclesTest {
    /** The body of other tests of this module; the names of the organs are the same on any mesh. */
    private static final MeshBudget COARSE = new MeshBudget(5000);

    /** Maps of access to a virtual body avoid all organs that are looked for. */
    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female", "high-colon-male"})
    void virtualBodiesLackNone(String preset) {
        Thorax body = VirtualThorax.ofPreset(preset, COARSE);
        List<String> names = Stream.concat(body.structures().stream(), body.organs().get().stream())
                .map(Structure::name)
                .toList();
        assertThat(AbsentObstacles.of(names)).isEmpty();
    }

    @Test
    void whatAScanDoesNotLabelIsNamed() {
        assertThat(AbsentObstacles.sentence(List.of("rib_08_R", "lung_R", "liver", "colon", "kidney_L")))
                .contains(
                        "not in this body and so not avoided: left lung, heart, aorta, inferior vena cava, portal vein,"
                                + " gall bladder, right kidney, stomach, duodenum");
        assertThat(AbsentObstacles.of(List.of("organ_kidney_L"))).contains("right kidney");
        assertThat(AbsentObstacles.of(List.of(
                        "LUNG_L",
                        "lung_R_upper",
                        "heart",
                        "aorta",
                        "inferior_vena_cava",
                        "liver_vessels",
                        "gallbladder",
                        "organ_kidneys",
                        "stomach",
                        "organ_bowel")))
                .isEmpty();
    }

    /** The right lung lies in the way of most needles to the liver. */
    @Test
    void aLungOfTheOtherSideAloneIsNone() {
        assertThat(AbsentObstacles.of(List.of("lung_L_lower", "lung_L_upper")))
                .contains("right lung")
                .doesNotContain("lungs", "left lung");
        assertThat(AbsentObstacles.of(List.of("liver")))
                .startsWith("lungs", "heart")
                .doesNotContain("right lung", "left lung");
    }
}
