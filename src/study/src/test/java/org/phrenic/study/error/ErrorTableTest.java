package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

class ErrorTableTest {
    private static final Scenario PAPER = Scenario.defaults().with("material=paper", "resolution=low");

    @TempDir
    private Path folder;

    private static ErrorTable.Row row(String preset, double stepS, double rmsMm, double cpuS) {
        return row(preset, stepS, rmsMm, cpuS, 0);
    }

    private static ErrorTable.Row row(String preset, double stepS, double rmsMm, double cpuS, double uncertaintyMm) {
        SolverSettings settings = new SolverSettings(IntegratorKind.VERLET, stepS, 2, 0.02);
        return new ErrorTable.Row(
                "paper",
                preset,
                "low",
                12_028,
                4,
                uncertaintyMm,
                10 * rmsMm,
                20 * rmsMm,
                new ErrorPoint(
                        settings, 1, rmsMm, 2 * rmsMm, 3 * rmsMm, 4 * rmsMm, 5 * rmsMm, cpuS, 2 * cpuS, 4 / cpuS, true,
                        false));
    }

    private static ErrorTable table(ErrorTable.Row... rows) {
        return new ErrorTable("made up", List.of(rows));
    }

    @Test
    void theCheapestSettingThatKeepsTheErrorIsChosenAndSaidInASentence() {
        ErrorTable table =
                table(row("quiet", 0.001, 0.001, 8), row("quiet", 0.005, 0.01, 2), row("quiet", 0.01, 0.1, 1));
        assertThat(table.cheapest(PAPER, 0.05).settings().timeStepS()).isEqualTo(0.005);
        assertThat(table.cheapest(PAPER, 0.01).settings().timeStepS()).isEqualTo(0.005);
        assertThat(table.cheapest(PAPER, 1).settings().timeStepS()).isEqualTo(0.01);
        assertThat(table.cheapest(PAPER, 0.05).sentence(PAPER))
                .contains("0.05 mm", "verlet, step 0.005 s, 2 sweeps, refresh 0.02 s", "0.0100 mm rms")
                .endsWith("on 4 s of a quiet breath of the virtual adult male at low resolution.");
    }

    /** A reference that is not known that well promises no such error. */
    @Test
    void theUncertaintyOfTheReferenceCounts() {
        ErrorTable table = table(row("quiet", 0.01, 0.04, 1, 0.02), row("quiet", 0.005, 0.03, 2, 0.01));
        assertThat(table.cheapest(PAPER, 0.05).settings().timeStepS()).isEqualTo(0.005);
        assertThat(table.cheapest(PAPER, 0.07).settings().timeStepS()).isEqualTo(0.01);
        assertThatThrownBy(() -> table.cheapest(PAPER, 0.035)).hasMessageContaining("at least 0.0400 mm");
    }

    @Test
    void whatIsChosenIsWhatAScenarioThenHas() {
        SolverSettings settings =
                table(row("quiet", 0.005, 0.01, 2)).cheapest(PAPER, 0.05).settings();
        assertThat(SolverSettings.of(PAPER.with(settings.assignments("test")))).isEqualTo(settings);
    }

    @Test
    void anErrorThatNothingKeepsIsRefusedWithTheLeastThereIs() {
        ErrorTable table = table(row("quiet", 0.001, 0.0012, 8));
        assertThatThrownBy(() -> table.cheapest(PAPER, 0.001))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 0.001 mm")
                .hasMessageContaining("at least 0.00120 mm");
        assertThat(ErrorReport.cheapestSentence(table, PAPER, 0.001))
                .isEqualTo(
                        "No setting that was measured keeps this error; --max-error: found 0.001 mm, expected at least"
                                + " 0.00120 mm, the least that was measured for material paper at resolution low.");
        assertThat(ErrorReport.cheapestSentence(table, PAPER, 0.01))
                .isEqualTo(table.cheapest(PAPER, 0.01).sentence(PAPER));
        assertThatThrownBy(() -> table.cheapest(Scenario.defaults(), 1))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("material physical");
    }

    @Test
    void theLeastErrorThatARefusalStatesIsAccepted() {
        ErrorTable table = table(row("quiet", 0.001, 0.0012342, 8));
        assertThatThrownBy(() -> table.cheapest(PAPER, 0.00123)).hasMessageContaining("at least 0.00124 mm");
        assertThat(table.cheapest(PAPER, 0.00124).settings().timeStepS()).isEqualTo(0.001);
    }

    @Test
    void aResolutionThatWasNotMeasuredIsTakenForTheFinestThatWasAndTheSentenceNamesIt() {
        SettingChoice chosen = table(row("quiet", 0.005, 0.01, 2)).cheapest(PAPER.with("resolution=high"), 0.05);
        assertThat(chosen.settings().timeStepS()).isEqualTo(0.005);
        assertThat(chosen.sentence(PAPER)).contains("at low resolution");
    }

    /** Cost and error of one body say little about another. */
    @Test
    void theSentenceNamesTheBodyThatWasMeasured() {
        ErrorTable table = table(row("quiet", 0.005, 0.01, 2));
        assertThat(ErrorReport.cheapestSentence(table, PAPER.with("anatomy=virtual/adult-female"), 0.05))
                .contains("breath of the virtual adult female at");
        assertThat(ErrorReport.cheapestSentence(table, PAPER.with("anatomy=data"), 0.05))
                .contains("breath of the body data at");
    }

    @Test
    void breathingThatWasMeasuredIsChosenFromItsOwnRows() {
        ErrorTable table = table(row("quiet", 0.01, 0.01, 1), row("deep", 0.01, 0.06, 1), row("deep", 0.005, 0.02, 2));
        assertThat(table.cheapest(PAPER.with("preset=deep"), 0.05).settings().timeStepS())
                .isEqualTo(0.005);
        assertThat(table.cheapest(PAPER.with("preset=sniff"), 0.05).settings().timeStepS())
                .isEqualTo(0.01);
    }

    @Test
    void itIsWrittenAndReadBackAndNewerRowsReplaceThoseOfTheirScene() {
        Path file = folder.resolve("settings.csv");
        ErrorTable old = table(row("quiet", 0.01, 0.01, 1), row("deep", 0.01, 0.06, 1, 0.005));
        old.with(table(row("quiet", 0.005, 0.002, 2))).write(file);
        assertThat(ErrorTable.read(file).rows())
                .containsExactly(row("deep", 0.01, 0.06, 1, 0.005), row("quiet", 0.005, 0.002, 2));
        assertThat(ErrorTable.read(file).rows().get(0).measurement())
                .containsEntry("start_rms_mm", 5 * 0.06)
                .containsEntry("cpu_s", 1.0)
                .containsEntry("wall_s", 2.0);
    }

    /** Rows of several measurements stand side by side in one column. */
    @Test
    void speedIsThatOverProcessorTimeWhateverAFileStates() throws Exception {
        Path file = folder.resolve("settings.csv");
        table(row("quiet", 0.01, 0.01, 1)).write(file);
        String written = Files.readString(file);
        Files.writeString(file, written.replace(",2.0,4.0,", ",2.0,2.0,"));
        assertThat(Files.readString(file)).isNotEqualTo(written);
        ErrorTable.read(file).write(file);
        assertThat(Files.readString(file)).isEqualTo(written);
    }

    @Test
    void someSettingsReplaceTheirRowsAndTheFrontIsThatOfAll() {
        ErrorTable old = table(row("quiet", 0.01, 0.01, 1), row("quiet", 0.005, 0.002, 2), row("deep", 0.01, 0.06, 1));
        List<ErrorTable.Row> merged =
                old.withSettings(table(row("quiet", 0.01, 0.02, 3))).rows();
        assertThat(merged).hasSize(3).contains(row("deep", 0.01, 0.06, 1), row("quiet", 0.005, 0.002, 2));
        assertThat(merged)
                .filteredOn(row ->
                        row.preset().equals("quiet") && row.point().settings().timeStepS() == 0.01)
                .singleElement()
                .satisfies(row -> {
                    assertThat(row.point().rmsMm()).isEqualTo(0.02);
                    assertThat(row.point().paretoOptimal()).isFalse();
                });
    }

    @Test
    void rowsOverAnotherTimeAreRefused() {
        ErrorTable table = table(row("quiet", 0.01, 0.01, 1));
        table.requireTime(PAPER, 4);
        table.requireTime(PAPER.with("preset=deep"), 2);
        assertThatThrownBy(() -> table.requireTime(PAPER, 2))
                .isInstanceOf(BadInputException.class)
                .hasMessage("made up: found rows of paper, quiet, low over 4 s, expected the 2 s of the new ones"
                        + " (--until 4, or all settings)");
    }

    @Test
    void aTableThatIsWrongIsRefusedWithItsLine() throws Exception {
        Path file = folder.resolve("settings.csv");
        table(row("quiet", 0.01, 0.01, 1)).write(file);
        Files.writeString(file, Files.readString(file).replace("verlet", "leapfrog"));
        assertThatThrownBy(() -> ErrorTable.read(file))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("settings.csv")
                .hasMessageContaining("line 2")
                .hasMessageContaining("leapfrog");
    }
}
