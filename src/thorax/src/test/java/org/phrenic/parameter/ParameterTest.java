package org.phrenic.parameter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Map;
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
    private static final Map<String, String> UNITS = Map.ofEntries(
            Map.entry("_n_per_m", "N/m"),
            Map.entry("_ns_per_m", "N s/m"),
            Map.entry("_mn", "mN"),
            Map.entry("_kpa", "kPa"),
            Map.entry("_kg", "kg"),
            Map.entry("_kg_per_m2", "kg/m^2"),
            Map.entry("_m_per_s2", "m/s^2"),
            Map.entry("_mm", "mm"),
            Map.entry("_ms", "ms"),
            Map.entry("_s", "s"),
            Map.entry("_per_s", "1/s"),
            Map.entry("_per_min", "1/min"),
            Map.entry("_deg", "deg"));

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

    /** The end of a key is the unit of its value; a number without a unit has the unit 1. */
    @ParameterizedTest
    @MethodSource("org.phrenic.model.material.Materials#parameters")
    void theKeyNamesTheUnit(Parameter parameter) {
        String unit = UNITS.entrySet().stream()
                .filter(e -> parameter.key().endsWith(e.getKey()))
                .max(Comparator.comparing(e -> e.getKey().length()))
                .map(Map.Entry::getValue)
                .orElse("1");
        assertThat(parameter.unit()).isEqualTo(unit);
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
