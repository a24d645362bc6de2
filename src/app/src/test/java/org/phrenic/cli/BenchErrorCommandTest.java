package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.study.error.ErrorTable;

class BenchErrorCommandTest {
    @TempDir
    private Path folder;

    @Test
    void aQuickStudyLeavesTableReportAndChart() throws Exception {
        CommandLineRun run = CommandLineRun.of(
                "bench", "error", "--quick", "--material", "paper", "--max-error", "0.01", "--out", folder.toString());
        assertThat(run.exitCode()).isZero();
        assertThat(run.out())
                .contains(
                        "Reference: rk4",
                        "front",
                        "default",
                        "For an error of at most 0.01 mm",
                        "on 0.2 s of a quiet breath");
        assertThat(Files.readString(folder.resolve("error.md"))).contains("## paper, low", "symplectic-euler");
        assertThat(Files.readString(folder.resolve("error.json"))).contains("\"reference_halving_rms_mm\"");
        assertThat(ErrorTable.read(folder.resolve("error.csv")).rows()).hasSizeGreaterThan(4);
        BufferedImage chart = ImageIO.read(folder.resolve("error.png").toFile());
        assertThat(chart.getWidth()).isEqualTo(1200);
    }

    /** What took minutes is not lost because the bound was too low. */
    @Test
    void aMeasurementIsToldThoughNothingInItKeepsTheErrorThatWasAskedFor() {
        CommandLineRun run = CommandLineRun.of(
                "bench",
                "error",
                "--quick",
                "--material",
                "paper",
                "--integrator",
                "verlet",
                "--time-step",
                "0.01",
                "--sweeps",
                "1",
                "--max-error",
                "1e-9");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.out())
                .contains("Reference: rk4", "No setting that was measured keeps this error", "expected at least");
    }

    /** Samples of a run with steps of 7 ms lie 2 ms from those of its reference, in which the domes move by 0.07 mm. */
    @Test
    void aStepThatDoesNotDivideTheSamplingIntervalIsRefused() {
        CommandLineRun run = CommandLineRun.of("bench", "error", "--quick", "--time-step", "0.01,0.007");
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("found 0.007 s, expected one that divides 0.1 s");
    }

    @Test
    void theWholeErrorLeavesAPageAChartAndItsMeasurements() throws Exception {
        CommandLineRun run = CommandLineRun.of(
                "bench",
                "error",
                "--whole",
                "--quick",
                "--part",
                "time,space,equilibrium",
                "--made-by",
                "Commit abc",
                "--out",
                folder.toString());
        assertThat(run.exitCode()).isZero();
        assertThat(run.out()).contains("virtual man", "stormer", "default");
        assertThat(Files.readString(folder.resolve("error.md")))
                .contains("Commit abc", "phrenic bench error --whole --quick", "error.png");
        assertThat(Files.readString(folder.resolve("budget.csv"))).contains("time,virtual man,quiet");
        assertThat(ImageIO.read(folder.resolve("error.png").toFile()).getWidth())
                .isEqualTo(1200);
    }

    /** The error in time alone, as a point of the chart, would pass for the whole. */
    @Test
    void aPartOfTheWholeErrorIsNotChartedAsTheWhole() throws Exception {
        CommandLineRun run =
                CommandLineRun.of("bench", "error", "--whole", "--quick", "--part", "time", "--out", folder.toString());
        assertThat(run.exitCode()).isZero();
        assertThat(folder.resolve("error.png")).doesNotExist();
        assertThat(Files.readString(folder.resolve("error.md"))).doesNotContain("error.png");
    }

    @Test
    void whatCannotBeMeasuredIsRefusedInASentenceBeforeAnythingRuns() {
        assertRefused("expected any other key", "--set", "time_step_s=0.01");
        assertRefused("--integrator: found 'leapfrog', expected one of", "--integrator", "leapfrog");
        assertRefused("--resolution lwo: key", "--whole", "--resolution", "lwo");
        assertRefused("--sweeps", "--sweeps", "0");
        assertRefused("--max-error", "--max-error", "none");
        assertRefused("--set: found it with --whole", "--whole", "--set", "damping_rate_per_s=1");
        assertRefused("--until: found it with --whole", "--whole", "--until", "1");
        assertRefused("--beside: found it without --whole", "--beside", "data/scenarios/heavy-tissue.yaml");
        assertRefused("--quick: found it with --check", "--check", "data/error/settings.csv", "--quick");
        assertRefused("--made-by: found it without --out", "--made-by", "me");
        for (String unread : List.of("--resolution", "--scan", "--beside")) {
            assertRefused(unread + ": found it with --quick", "--whole", "--quick", unread, "high");
        }
        assertRefused("--resolution: found it with --quick", "--quick", "--resolution", "high");
        assertRefused("--part: found 'luck'", "--whole", "--part", "luck");
        assertRefused("--scan: found no folder", "--whole", "--scan", "nowhere");
        String none = folder.toString();
        assertRefused(none + ": no mesh", "--whole", "--part", "order", "--resolution", "low", "--scan", none);
    }

    /** Its own mesh or recording would stand in rows that are named after another. */
    @Test
    void aScenarioBesideTheDefaultsIsOfAnyMeshAndBreath() throws Exception {
        String beside = "data/scenarios/heavy-tissue.yaml";
        assertRefused(
                "--beside: found it without the part equilibrium", "--whole", "--part", "time", "--beside", beside);
        String breaths = IntStream.range(0, 100)
                .mapToObj(i -> i + "," + (i % 4 == 2 ? 10 : 0))
                .collect(Collectors.joining("\n"));
        Files.writeString(folder.resolve("breath.csv"), "time_s,amplitude\n" + breaths);
        for (String own : List.of("mesh_vertices: 3000", "trace: breath.csv")) {
            Path file = Files.writeString(folder.resolve("own.yaml"), own);
            assertRefused(
                    "found " + own.substring(0, own.indexOf(':')) + ", expected a scenario for each breath and mesh",
                    "--whole",
                    "--part",
                    "equilibrium",
                    "--beside",
                    file.toString());
        }
    }

    private Path shippedTable() throws IOException {
        return Files.copy(Path.of("data/error/settings.csv"), folder.resolve("settings.csv"));
    }

    /** From such rows --max-error would choose settings for a scene that they are not of. */
    @Test
    void rowsOfAnotherSceneThanTheyNameAreNotPutIntoATable() throws Exception {
        String table = shippedTable().toString();
        assertRefused("--write: found it with --quick", "--quick", "--write", table);
        assertRefused("found it with --write, expected preset", "--write", table, "--set", "depth=0.5");
        assertRefused("--threads: found 2 with --write, expected 1", "--write", table, "--threads", "2");
        assertRefused(
                "settings.csv: found rows of physical, quiet, low over 2 s, expected the 4 s",
                "--write",
                table,
                "--resolution",
                "low",
                "--integrator",
                "rk4");
        assertThat(Path.of(table)).hasSameTextualContentAs(Path.of("data/error/settings.csv"));
    }

    @Test
    void someSettingsReplaceTheirRowsOfATableAndNoOthers() throws Exception {
        Path table = folder.resolve("settings.csv");
        Files.copy(Path.of("data/error/settings.csv"), table);
        List<ErrorTable.Row> before = ErrorTable.read(table).rows().stream()
                .filter(row ->
                        !row.material().equals("paper") || !row.resolution().equals("low"))
                .toList();
        new ErrorTable("others", before).write(table);
        for (String step : List.of("0.01", "0.005")) {
            CommandLineRun run = CommandLineRun.of(
                    "bench",
                    "error",
                    "--material",
                    "paper",
                    "--resolution",
                    "low",
                    "--integrator",
                    "verlet",
                    "--time-step",
                    step,
                    "--until",
                    "0.1",
                    "--sweeps",
                    "1",
                    "--refresh",
                    "0.02",
                    "--write",
                    table.toString());
            assertThat(run.exitCode()).as(run.err()).isZero();
        }
        List<ErrorTable.Row> after = ErrorTable.read(table).rows();
        assertThat(after).containsAll(before);
        assertThat(after.stream()
                        .filter(row -> !before.contains(row))
                        .map(row -> row.point().settings())
                        .map(s -> s.integrator().label() + " " + s.timeStepS()))
                .contains("verlet 0.01", "verlet 0.005");
    }

    @Test
    void aTableWithoutRowsDoesNotPass() throws Exception {
        Path table = folder.resolve("empty.csv");
        String shipped = Files.readString(Path.of("data/error/settings.csv"));
        Files.writeString(table, shipped.substring(0, shipped.indexOf('\n') + 1));
        assertRefused("empty.csv: found no row", "--check", table.toString());
    }

    private static void assertRefused(String sentence, String... options) {
        String[] all = new String[2 + options.length];
        all[0] = "bench";
        all[1] = "error";
        System.arraycopy(options, 0, all, 2, options.length);
        CommandLineRun run = CommandLineRun.of(all);
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains(sentence);
    }

    @Test
    void aRunTakesTheCheapestSettingThatKeepsAnErrorAndSaysSo() throws Exception {
        CommandLineRun run = CommandLineRun.of(
                "run",
                "--max-error",
                "0.01",
                "--material",
                "paper",
                "--resolution",
                "low",
                "--steps",
                "2",
                "--set",
                "lungs=off",
                "--out",
                folder.toString());
        assertThat(run.exitCode()).isZero();
        assertThat(run.out()).contains("For an error of at most 0.01 mm");
        assertThat(run.err()).contains("For an error of at most 0.01 mm");
        assertThat(Files.readString(folder.resolve("summary.json"))).contains("\"chosen\": \"For an error");
        assertThat(Files.readString(folder.resolve("scenario.yaml"))).contains("projection_sweeps:", "refresh_s:");
    }

    @Test
    void anErrorThatNothingKeepsIsRefused() {
        CommandLineRun run = CommandLineRun.of("run", "--max-error", "0.0001", "--material", "physical");
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("--max-error: found 0.0001 mm, expected at least");
    }
}
