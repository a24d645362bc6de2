package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.FailureHandler;
import org.phrenic.cli.report.RunReport;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.scenario.Settings;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import picocli.CommandLine;

class CommandsTest {
    private static final Path BENCH = Path.of("../shared/bench");
    /** Engines that add in another order agree this far on the check of the bare workload. */
    private static final double BENCH_TOLERANCE = 1e-10;

    @TempDir
    Path folder;

    /** JSON is YAML; the library that reads scenarios reads it too. */
    private static Map<String, Object> json(String text) {
        return new Yaml(new SafeConstructor(new LoaderOptions())).load(text);
    }

    private static CommandLineRun done(String... args) {
        CommandLineRun run = CommandLineRun.of(args);
        assertThat(run.exitCode()).as(run.err()).isZero();
        return run;
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "run", "info", "bench", "regress"})
    void everyCommandExplainsItselfOnStdout(String command) {
        CommandLineRun run = command.isEmpty() ? done("--help") : done(command, "--help");
        assertThat(run.out()).contains("Usage: phrenic").contains("Example").contains("--debug");
        assertThat(run.err()).isEmpty();
    }

    @Test
    void helpAndVersionMayStandBeforeACommand() {
        assertThat(done("--help", "run").out()).contains("Usage: phrenic");
        assertThat(done("bench", "--help", "speed").out()).contains("Usage: phrenic bench");
        assertThat(done("--version", "run").out()).contains("Not for clinical use");
    }

    @Test
    void theVersionComesWithTheNotice() {
        assertThat(done("--version").out()).contains("phrenic").contains("Not for clinical use");
    }

    @Test
    void infoMeasuresAMesh() {
        Path mesh = folder.resolve("box.ply");
        MeshFiles.write(mesh, BoxThorax.box(1, 2, 3, 5));
        CommandLineRun run = done("info", mesh.toString(), "--json");
        List<?> files = (List<?>) json(run.out()).get("files");
        assertThat(files)
                .singleElement(InstanceOfAssertFactories.map(String.class, Object.class))
                .containsEntry("vertices", 8)
                .containsEntry("triangles", 12)
                .containsEntry("components", 1)
                .containsEntry("closed", true)
                .containsEntry("manifold", true)
                .containsEntry("area", 600.0)
                .containsEntry("volume", 1000.0)
                .containsEntry("smallest_angle_deg", 45.0)
                .containsEntry("bounds_minimum", List.of(-4.0, -3.0, -2.0));
    }

    @Test
    void infoSaysOfEveryKeyOfAScenarioWhoSetIt() throws IOException {
        Path scenario = Files.writeString(folder.resolve("mine.yaml"), "preset: deep\ndepth: 0.5\n");
        String text = done("info", scenario.toString()).out();
        assertThat(text)
                .containsPattern("depth +0.5 +file")
                .containsPattern("rate_per_min +7.5 1/min +preset")
                .containsPattern("muscle_stiffness_n_per_m +300 N/m +default")
                .containsPattern("duration_s +16 s +preset");
    }

    @Test
    void infoSaysWhatAFolderHoldsAndLacks() {
        BoxThorax.write(folder, 140, 1);
        String text = done("info", folder.toString()).out();
        assertThat(text)
                .contains("axes LPS")
                .containsPattern("rib +24")
                .contains("lung_R")
                .contains("liver");
    }

    @Test
    void benchGivesTheDisplacementOnWhichOtherEnginesAgree() {
        assumeTrue(Files.isDirectory(BENCH), "no ../shared/bench here: the published workload is not at hand");
        CommandLineRun run = done(
                "bench",
                "--mesh",
                BENCH + "/dome_6633.obj",
                "--fixed",
                BENCH + "/dome_6633.fixed.txt",
                "--loaded",
                BENCH + "/dome_6633.loaded.txt",
                "--links",
                BENCH + "/dome_6633.links.txt",
                "--steps",
                "10",
                "--json");
        Map<String, Object> result = json(run.out());
        assertThat(result)
                .containsKeys("steps_per_s", "min", "max", "edges", "threads", "kernel", "state_sha256")
                .containsEntry("nodes", 6633)
                .containsEntry("links", 1327)
                .containsEntry("integrator", "symplectic-euler");
        // README of the bare workload: 6,633 nodes with links.
        assertThat((double) result.get("mean_dz_200")).isCloseTo(-0.00501653054, within(BENCH_TOLERANCE));
    }

    @Test
    void theTableOfARunIsAlignedWithSpeedLastAndTheNotice() {
        Map<String, Object> summary = new LinkedHashMap<>();
        summary.put("scenario", "quiet");
        summary.put("nodes", 16023);
        summary.put("steps_per_s", 1234.5678);
        summary.put("dome_excursion_right_mm", 15.249999);
        summary.put("dome_excursion_right_peak_to_peak_mm", 15.5);
        summary.put("max_rigid_link_error", 1.23456e-15);
        summary.put("state_sha256", "0a1b2c");
        assertThat(RunReport.table(summary))
                .isEqualTo(
                        """
                        quantity                   value  unit  peak to peak
                        nodes                      16023
                        dome excursion right       15.25  mm            15.5
                        max rigid link error  1.2346E-15

                        steps per s               1234.6

                        state_sha256 0a1b2c

                        For research and training only. Not for clinical use.
                        """);
    }

    @Test
    void whatACommandLacksIsNamedWithoutWhatWasGiven() {
        CommandLineRun bench = CommandLineRun.of("bench", "--mesh", "X");
        assertThat(bench.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(bench.err())
                .startsWith("phrenic: found no --fixed FILE and --loaded FILE")
                .doesNotContain("--mesh");
    }

    @Test
    void whatNobodyForesawIsOneSentenceAndExitCodeOne() {
        FailureHandler failures = new FailureHandler(() -> false);
        StringWriter err = new StringWriter();
        CommandLine line = SubCommands.commandLine(new Phrenic()).setErr(new PrintWriter(err));
        int code = failures.handleExecutionException(new IllegalStateException("a\n  b"), line, null);
        assertThat(code).isEqualTo(ExitCode.FAILURE);
        assertThat(err.toString().strip())
                .isEqualTo("phrenic: an unexpected failure, IllegalStateException (a b); --debug shows where");
    }

    @Test
    void theUsageDocumentsNameEveryKeyAndEveryCommand() throws IOException {
        String scenario = Files.readString(Path.of("docs/usage/run.md"));
        String parameters = Files.readString(Path.of("docs/parameters.md"));
        assertThat(Settings.keys())
                .allMatch(key -> scenario.contains("`" + key + "`") || parameters.contains("`" + key + "`"));
        String index = Files.readString(Path.of("docs/usage.md"));
        assertThat(SubCommands.commandLine(new Phrenic()).getSubcommands().keySet())
                .allMatch(command -> index.contains("`phrenic " + command));
    }
}
