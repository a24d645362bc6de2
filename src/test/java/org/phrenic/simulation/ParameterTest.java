package org.phrenic.simulation;

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
        assertThat(Parameter.of(parameter.key())).isSameAs(parameter);
        assertThat(parameter.minimum()).isLessThan(parameter.maximum());
        for (Material material : Material.values()) {
            double value = parameter.defaultFor(material);
            assertThat(Double.isNaN(value) || parameter.problem(value).isEmpty())
                    .isTrue();
        }
        assertThat(parameter.meaning()).endsWith(".");
    }

    @Test
    void thePaperStatesItsConstants() {
        // Villard, Bourne and Bello 2009: k = 15, m = 0.1, c = 0.02 (live tuning).
        assertThat(Parameter.SPRING_STIFFNESS.defaultFor(Material.PAPER)).isEqualTo(15);
        assertThat(Parameter.NODE_MASS.defaultFor(Material.PAPER)).isEqualTo(0.1);
        assertThat(Parameter.DAMPING.defaultFor(Material.PAPER)).isEqualTo(0.02);
        assertThat(Parameter.SPRING_STIFFNESS.isUsedBy(Material.PHYSICAL)).isFalse();
    }

    @Test
    void aValueOutOfRangeOrNoNumberIsRefusedInOneSentence() {
        assertThat(Parameter.DEPTH.check(2)).isEqualTo(2);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Parameter.MUSCLE_STIFFNESS.check(5))
                .withMessage("muscle_stiffness_n_per_m: found 5, expected 30 to 3000 N/m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Parameter.DEPTH.check(Double.NaN))
                .withMessage("depth: found NaN, expected 0 to 2");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Parameter.of("rate_per_minute"))
                .withMessage("found an unknown parameter 'rate_per_minute', did you mean 'rate_per_min'?");
    }

    @Test
    void theDocumentedTableIsThisTable() throws IOException {
        assertThat(Files.readString(Path.of("docs/parameters.md"))).isEqualTo(Parameter.markdown());
    }
}
