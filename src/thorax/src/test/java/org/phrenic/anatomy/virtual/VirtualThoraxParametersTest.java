package org.phrenic.anatomy.virtual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;

class VirtualThoraxParametersTest {
    private static String male() {
        return ShippedFile.text("thorax/adult-male.yaml");
    }

    private static void assertRefused(String text, String... words) {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> YamlDocument.parse("body.yaml", text).bind(VirtualThoraxParameters.class))
                .withMessageStartingWith("body.yaml: ")
                .satisfies(e -> assertThat(e.getMessage()).contains(words).doesNotContain("\n"));
    }

    @Test
    void bothBodiesAreThere() {
        assertThat(VirtualThoraxParameters.preset("adult-male").sternum().bodyMm())
                .isEqualTo(101.1);
        assertThat(VirtualThoraxParameters.preset("adult-female").ribs().arcMm().size())
                .isEqualTo(12);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> VirtualThoraxParameters.preset("child"))
                .withMessageContaining("child");
    }

    @Test
    void theBodyWithAHighColonIsTheManButForItsColonAndSkin() {
        VirtualThoraxParameters man = VirtualThoraxParameters.preset("adult-male");
        VirtualThoraxParameters stout = VirtualThoraxParameters.preset("high-colon-male");
        assertThat(stout)
                .usingRecursiveComparison()
                .ignoringFields("name", "skin.sections", "organs.parts")
                .isEqualTo(man);
        for (int i = 0; i < man.organs().parts().size(); i++) {
            boolean colon = man.organs().parts().get(i).name().equals("colon");
            assertThat(stout.organs().parts().get(i).equals(man.organs().parts().get(i)))
                    .as(man.organs().parts().get(i).name())
                    .isNotEqualTo(colon);
        }
        // The belly's front lies 34 mm before that of the man, as the row at the lower end says.
        assertThat(man.skin().sections().get(0).at(2)
                        - stout.skin().sections().get(0).at(2))
                .isEqualTo(34);
    }

    @Test
    void aMisspelledKeyIsNamed() {
        assertRefused(male().replace("  xiphoid_mm:", "  xyphoid_mm:"), "sternum", "xiphoid_mm");
    }

    @Test
    void anUnknownKeyIsNamed() {
        assertRefused(male().replace("skin:\n", "skin:\n  colour: 3\n"), "skin", "colour");
    }

    @Test
    void aWordForANumberIsNamed() {
        assertRefused(male().replace("gap_mm: 1 ", "gap_mm: wide "), "gap_mm", "wide", "a number");
    }

    @Test
    void aListOfTheWrongLengthIsNamed() {
        assertRefused(
                male().replace("join_fraction: [0.5, 0.45, 0.45]", "join_fraction: [0.5]"),
                "join_fraction",
                "a list of 3 numbers");
    }

    @Test
    void rowsThatDoNotRiseAreNamed() {
        assertRefused(
                male().replace("    - [-90, 114,", "    - [-190, 114,"), "chest_wall", "sections", "row 2", "rising");
    }

    @Test
    void textThatIsNoYamlIsRefused() {
        assertRefused("name: [", "YAML");
        assertRefused("just a sentence", "expected", "mapping");
    }
}
