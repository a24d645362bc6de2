package org.phrenic.parameter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ParameterTest {
    @ParameterizedTest
    @EnumSource(Parameter.class)
    void everyDefaultIsWithinItsRangeAndEveryKeyFindsItsParameter(Parameter parameter) {
        assertThat(Parameter.named(parameter.key())).isSameAs(parameter);
        assertThat(parameter.minimum()).isLessThan(parameter.maximum());
        for (TissueMaterial material : TissueMaterial.values()) {
            double value = parameter.defaultFor(material);
            assertThat(Double.isNaN(value) || parameter.rangeViolation(value).isEmpty())
                    .isTrue();
        }
        assertThat(parameter.description()).endsWith(".");
    }

    @Test
    void thePaperStatesItsConstants() {
        // Villard, Bourne and Bello 2009: k = 15, m = 0.1, c = 0.02 (live tuning).
        assertThat(Parameter.SPRING_STIFFNESS.defaultFor(TissueMaterial.PAPER)).isEqualTo(15);
        assertThat(Parameter.NODE_MASS.defaultFor(TissueMaterial.PAPER)).isEqualTo(0.1);
        assertThat(Parameter.DAMPING.defaultFor(TissueMaterial.PAPER)).isEqualTo(0.02);
        assertThat(Parameter.SPRING_STIFFNESS.isUsedBy(TissueMaterial.PHYSICAL)).isFalse();
    }

    @Test
    void aValueOutOfRangeOrNoNumberIsRefusedInOneSentence() {
        assertThat(Parameter.DEPTH.requireInRange(2)).isEqualTo(2);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Parameter.MUSCLE_STIFFNESS.requireInRange(5))
                .withMessage("muscle_stiffness_n_per_m: found 5, expected 30 to 3000 N/m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Parameter.DEPTH.requireInRange(Double.NaN))
                .withMessage("depth: found NaN, expected 0 to 2");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Parameter.named("rate_per_minute"))
                .withMessage("found an unknown parameter 'rate_per_minute', did you mean 'rate_per_min'?");
    }

    @Test
    void theDocumentedTableIsThisTable() throws IOException {
        assertThat(Files.readString(Path.of("docs/parameters.md"))).isEqualTo(Parameter.markdown());
    }
}
