package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.validation.LiverMotion;
import org.phrenic.study.validation.PhysiologyTable;
import org.phrenic.study.validation.ReferenceRange;
import picocli.CommandLine;

/** {@code phrenic validate}: exit codes and files. */
class ValidateCommandTest {
    /** A breath of one second of a coarse sheet alone. */
    private static final String[] FAST = {
        "validate",
        "--resolution",
        "low",
        "--set",
        "mesh_vertices=2000",
        "--set",
        "lungs=embedded",
        "--set",
        "sternum=kinematic",
        "--set",
        "rate_per_min=60"
    };

    private static final String TABLE =
            """
            rows:
              - key: dome_falls
                preset: quiet
                observable: dome_right_mm
                reduction: fall
                low: %s
                unit: mm
                confidence: S
                source: "people's domes go down"
                missed_because: nothing moves a dome so far
              - key: full_exhale
                preset: none
                low: 1
                unit: mm
                confidence: S
                source: someone
                note: nothing is driven below end-expiration
            """;

    @TempDir
    Path folder;

    private static CommandLineRun run(String... more) {
        String[] all = java.util.Arrays.copyOf(FAST, FAST.length + more.length);
        System.arraycopy(more, 0, all, FAST.length, more.length);
        return CommandLineRun.of(all);
    }

    private String table(String low) throws IOException {
        Path file = folder.resolve("table.yaml");
        Files.writeString(file, TABLE.formatted(low));
        return file.toString();
    }

    @Test
    void rangesThatAreMetGiveExitCode0AndTheReports() throws IOException {
        Path out = folder.resolve("out");
        CommandLineRun run = run("--table", table("1"), "--out", out.toString());
        assertThat(run.err()).isEqualTo("1 of 1 runs done: virtual/adult-male, quiet" + System.lineSeparator());
        assertThat(run.exitCode()).isZero();
        assertThat(run.out())
                .contains("dome_falls", "within", "not measurable here: nothing is driven", "passed", Disclaimer.TEXT);
        assertThat(out.resolve("validation.md")).content().contains("Verdict: passed", Disclaimer.TEXT, "dome\\_falls");
        assertThat(out.resolve("validation.json")).content().contains("\"passes\": true", Disclaimer.TEXT);
        assertThat(run.out()).as("a stated reason of a row that is met").doesNotContain("nothing moves");
        assertThat(out.resolve("validation.md")).content().doesNotContain("nothing moves");
        assertThat(out.resolve("validation.json")).content().doesNotContain("nothing moves");
    }

    /** A check of nothing is no passed check. */
    @Test
    void aPresetWithoutARowIsBadInput() throws IOException {
        CommandLineRun run = run("--table", table("1"), "--preset", "quiet,cough");
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err())
                .contains("--preset: found 'cough', of which the table has no row, expected quiet")
                .hasLineCount(1);
    }

    @Test
    void aDoctoredRangeGivesExitCode3() throws IOException {
        Path out = folder.resolve("out");
        CommandLineRun run = run("--table", table("1000"), "--json", "--out", out.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(run.out())
                .contains(
                        "\"verdict\": \"out\"",
                        "\"passes\": false",
                        "\"missed_because\": \"nothing moves a dome so far\"");
        assertThat(out.resolve("validation.md")).content().contains("OUT: nothing moves a dome so far");
    }

    @Test
    void aMissSaysItsReasonOrThatNoneIsKnown() throws IOException {
        CommandLineRun told = run("--table", table("1000"));
        assertThat(told.exitCode()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(told.out()).contains("OUT: nothing moves a dome so far");
        Path file = folder.resolve("untold.yaml");
        Files.writeString(file, TABLE.formatted("1000").replaceFirst(" *missed_because.*\n", ""));
        CommandLineRun untold = run("--table", file.toString());
        assertThat(untold.exitCode()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(untold.out()).contains("OUT: no reason is known yet");
    }

    @Test
    void badInputGivesExitCode2BeforeAnythingIsRun() throws IOException {
        for (String[] bad : new String[][] {
            {"--table", "no-such.yaml"},
            {"--table", table("many")},
            {"--resolution", "lwo"},
            {"--preset", "quiet,depe"},
            {"--set", "preset=deep"},
            {"--set", "dept=1"},
            {"--threads", "0"},
            {"--anatomy", "no/such/body"},
        }) {
            CommandLineRun run = CommandLineRun.of("validate", bad[0], bad[1]);
            assertThat(run.exitCode()).as(String.join(" ", bad)).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.err().lines()).as(run.err()).hasSize(1);
            assertThat(run.out()).isEmpty();
        }
    }

    @Test
    void aDiaphragmWithoutDomesIsNotMeasurable() throws IOException {
        Path file = folder.resolve("domes.yaml");
        Files.writeString(
                file,
                """
                rows:
                  - key: dome_level
                    preset: quiet
                    observable: dome_right_vertebra
                    reduction: start
                    low: 1
                    unit: 1
                    confidence: S
                    source: someone
                """);
        Path body = BoxThorax.write(Files.createDirectory(folder.resolve("box")), 140, 1);
        double[] corners = {-40, -60, 60, 40, -60, 60, 0, 80, 60, 0, 0, 120};
        int[] faces = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
        MeshFiles.write(body.resolve("diaphragm.ply"), new TriangleMesh(corners, faces));
        CommandLineRun run = run("--table", file.toString(), "--anatomy", body.toString());
        assertThat(run.err()).contains("2 of 2 runs done").doesNotContain("failure");
        assertThat(run.out()).contains("not measurable here: the body or the breath lacks what it is measured on");
    }

    @Test
    void theLiverAloneReadsNeitherPresetsNorSensitivity() {
        assertThat(CommandLineRun.of("validate", "--liver", "--sensitivity").err())
                .isEqualTo("phrenic: --sensitivity: found it with --liver, which does not read it"
                        + System.lineSeparator());
        assertThat(CommandLineRun.of("validate", "--liver", "--preset", "quiet").exitCode())
                .isEqualTo(ExitCode.BAD_INPUT);
    }

    /** A liver that moves by 5.1 to 17.3 mm in a quiet breath (PMC5978939) is in its range. */
    @Test
    void aLiverOutOfItsRangeGivesExitCode3() {
        Optional<ReferenceRange> quiet = PhysiologyTable.shipped().ranges().stream()
                .filter(r -> r.key().equals("liver_si_quiet"))
                .findFirst();
        assertThat(quiet).isPresent();
        assertThat(exitCode(liver(10, quiet))).isZero();
        assertThat(exitCode(liver(4, quiet))).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(exitCode(liver(4, Optional.empty()))).isZero();
    }

    private static int exitCode(LiverMotion motion) {
        ValidateCommand command = new ValidateCommand();
        new CommandLine(command).setOut(new PrintWriter(new StringWriter())).parseArgs("--liver");
        return command.liver(motion, Scenario.defaults());
    }

    private static LiverMotion liver(double siMm, Optional<ReferenceRange> range) {
        List<Optional<ReferenceRange>> ranges = List.of(range, Optional.empty(), Optional.empty(), Optional.empty());
        return new LiverMotion(
                List.of(new LiverMotion.Row("body", "quiet", siMm, 1, 1, siMm, siMm, siMm, 0, 0, ranges)), List.of());
    }
}
