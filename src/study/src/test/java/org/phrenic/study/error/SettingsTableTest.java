package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.document.ShippedFile;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.Hashes;
import org.phrenic.scenario.Scenario;

/** The table of settings that comes with the program, against new measurements of rows drawn by its hash. */
class SettingsTableTest {
    private static final int ROWS = 6;
    /** A material, drawn by the last hexadecimal digit of the hash. */
    private static final List<String> MATERIALS = List.of("physical", "paper");

    @TempDir
    private Path folder;

    private static boolean isCheap(ErrorTable.Row row) {
        IntegratorKind scheme = row.point().settings().integrator();
        return row.resolution().equals("low")
                && row.preset().equals("quiet")
                && scheme != IntegratorKind.BACKWARD_EULER
                && scheme != IntegratorKind.LAGGED;
    }

    @Test
    void sixRowsDrawnByItsHashAreMeasuredAgainWithin25Percent() throws Exception {
        Path file = folder.resolve("settings.csv");
        Files.writeString(file, ShippedFile.text("error/settings.csv"), StandardCharsets.UTF_8);
        String hash = Hashes.sha256(file);
        String material = MATERIALS.get(Character.digit(hash.charAt(hash.length() - 1), 16) % MATERIALS.size());
        List<ErrorTable.Row> drawn = TableCheck.draw(
                ErrorTable.read(file), hash, ROWS, row -> row.material().equals(material) && isCheap(row));
        assertThat(drawn).hasSize(ROWS);
        assertThat(TableCheck.measure(drawn, true)).allSatisfy(check -> assertThat(check.holds())
                .as(check.sentence() + "; phrenic bench error --write data/error/settings.csv")
                .isTrue());
    }

    @Test
    void everySettingThatAnErrorAsksForKeepsItWithTheUncertaintyOfItsReference() {
        ErrorTable table = ErrorTable.shipped();
        for (ErrorTable.Row row : table.rows()) {
            Scenario scenario = Scenario.defaults()
                    .with("material=" + row.material(), "preset=" + row.preset(), "resolution=" + row.resolution());
            SolverSettings chosen = table.cheapest(scenario, row.boundMm()).settings();
            ErrorTable.Row taken = table.rows().stream()
                    .filter(r -> r.scene().equals(row.scene())
                            && r.point().settings().equals(chosen))
                    .findFirst()
                    .orElseThrow();
            assertThat(taken.boundMm()).isLessThanOrEqualTo(row.boundMm());
            assertThat(taken.point().cpuS()).isLessThanOrEqualTo(row.point().cpuS());
        }
    }

    @Test
    void everyMaterialHasItsDefaultMarkedAndTheSchemesThatAreCheap() {
        for (String material : MATERIALS) {
            List<ErrorTable.Row> rows = ErrorTable.shipped().rows().stream()
                    .filter(r -> r.material().equals(material) && r.resolution().equals("low"))
                    .toList();
            Scenario scenario = Scenario.defaults().with("material=" + material, "resolution=low");
            assertThat(rows.stream().filter(r -> r.point().isDefault()).map(r -> r.point()
                            .settings()))
                    .containsExactly(SolverSettings.of(scenario));
            assertThat(rows.stream().map(r -> r.point().settings().integrator()))
                    .contains(
                            IntegratorKind.VERLET,
                            IntegratorKind.STORMER,
                            IntegratorKind.RK2,
                            IntegratorKind.RK4,
                            IntegratorKind.SYMPLECTIC_EULER);
        }
    }

    @Test
    void aRowThatIsOffByMoreThanAQuarterDoesNotHold() {
        ErrorTable.Row row = ErrorTable.shipped().rows().get(0);
        assertThat(new TableCheck(row, 1, 1.2).holds()).isTrue();
        assertThat(new TableCheck(row, 1, 1.3).holds()).isFalse();
        assertThat(new TableCheck(row, 1, Double.NaN).holds()).isFalse();
        assertThat(new TableCheck(row, 1, 1.3).sentence()).contains("stale");
    }
}
