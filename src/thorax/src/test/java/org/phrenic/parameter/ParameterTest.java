package org.phrenic.parameter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.model.material.TissueMass;
import org.phrenic.scenario.ParameterTable;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;

class ParameterTest {
    @ParameterizedTest
    @MethodSource("org.phrenic.model.material.Materials#parameters")
    void everyDefaultIsWithinItsRangeAndEveryKeyFindsItsParameter(Parameter parameter) {
        assertThat(Settings.parameter(parameter.key())).isSameAs(parameter);
        assertThat(parameter.minimum()).isLessThan(parameter.maximum());
        for (TissueMaterial material : Materials.ALL) {
            double value = material.defaultOf(parameter, Scenario.defaults());
            assertThat(Double.isNaN(value) || parameter.rangeViolation(value).isEmpty())
                    .isTrue();
        }
        assertThat(parameter.description()).endsWith(".");
    }

    @Test
    void thePaperStatesItsConstants() {
        // Villard, Bourne and Bello 2009: k = 15, m = 0.1, c = 0.02 (live tuning).
        assertThat(Materials.PAPER.defaultOf(SheetSprings.SPRING_STIFFNESS, Scenario.defaults()))
                .isEqualTo(15);
        assertThat(Materials.PAPER.defaultOf(TissueMass.NODE_MASS, Scenario.defaults()))
                .isEqualTo(0.1);
        assertThat(Materials.PAPER.defaultOf(TissueMass.DAMPING, Scenario.defaults()))
                .isEqualTo(0.02);
        assertThat(Materials.PHYSICAL.uses(SheetSprings.SPRING_STIFFNESS)).isFalse();
    }

    @Test
    void aValueOutOfRangeOrNoNumberIsRefusedInOneSentence() {
        assertThat(Breathing.DEPTH.requireInRange(2)).isEqualTo(2);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SheetSprings.MUSCLE_STIFFNESS.requireInRange(5))
                .withMessage("muscle_stiffness_n_per_m: found 5, expected 30 to 3000 N/m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Breathing.DEPTH.requireInRange(Double.NaN))
                .withMessage("depth: found NaN, expected 0 to 2");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Settings.parameter("rate_per_minute"))
                .withMessage("found an unknown parameter 'rate_per_minute', did you mean 'rate_per_min'?");
    }

    @Test
    void theDocumentedTableIsThisTable() throws IOException {
        assertThat(Files.readString(Path.of("docs/parameters.md"))).isEqualTo(ParameterTable.markdown());
    }
}
