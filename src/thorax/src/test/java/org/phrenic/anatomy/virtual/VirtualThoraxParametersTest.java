package org.phrenic.anatomy.virtual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;

class VirtualThoraxParametersTest {
    private static String male() throws IOException {
        try (InputStream in =
                VirtualThoraxParameters.class.getResourceAsStream("/org/phrenic/data/thorax/adult-male.yaml")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
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
    void aMisspelledKeyIsNamed() throws IOException {
        assertRefused(male().replace("  xiphoid_mm:", "  xyphoid_mm:"), "sternum", "xiphoid_mm");
    }

    @Test
    void anUnknownKeyIsNamed() throws IOException {
        assertRefused(male().replace("skin:\n", "skin:\n  colour: 3\n"), "skin", "colour");
    }

    @Test
    void aWordForANumberIsNamed() throws IOException {
        assertRefused(male().replace("gap_mm: 1 ", "gap_mm: wide "), "gap_mm", "wide", "a number");
    }

    @Test
    void aListOfTheWrongLengthIsNamed() throws IOException {
        assertRefused(
                male().replace("join_fraction: [0.5, 0.45, 0.45]", "join_fraction: [0.5]"),
                "join_fraction",
                "a list of 3 numbers");
    }

    @Test
    void rowsThatDoNotRiseAreNamed() throws IOException {
        assertRefused(
                male().replace("    - [-90, 114,", "    - [-190, 114,"), "chest_wall", "sections", "row 2", "rising");
    }

    @Test
    void textThatIsNoYamlIsRefused() {
        assertRefused("name: [", "YAML");
        assertRefused("just a sentence", "expected", "mapping");
    }
}
