package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;

class BenchAccessCommandTest {
    @TempDir
    private Path folder;

    @Test
    void namesExercisesAndBodiesThatCannotBeMeasured() throws IOException {
        String body = Files.createDirectory(folder.resolve("no-body")).toString();
        String out = folder.resolve("out").toString();
        String plan = "data/exercises/1-large-target.yaml";
        CommandLineRun exercises =
                CommandLineRun.of("bench", "exercises", plan, "--set", "anatomy=" + body, "--out", out);
        CommandLineRun imaging = CommandLineRun.of("bench", "imaging", body, "--out", out);
        for (CommandLineRun run : new CommandLineRun[] {exercises, imaging}) {
            assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.CHECK_FAILED);
            assertThat(run.err()).contains("no mesh has the name of a structure");
        }
        assertThat(folder.resolve("out/exercises.md")).content().contains("## Not done");
        assertThat(folder.resolve("out/imaging.md")).content().contains("## Not imaged");
    }

    @Test
    void aPlanWhoseNeedleIsTooShortIsReportedWithoutATime() throws IOException {
        Path plan = folder.resolve("short.yaml");
        Files.writeString(
                plan,
                """
                title: A needle that is too short
                set: {preset: rapid-shallow, rate_per_min: 70, resolution: low, mesh_vertices: 2000, lungs: embedded,
                  sternum: kinematic}
                phases: 3
                target: {rest_mm: [-70, 0, 50], diameter_mm: 15}
                needle: {gauge: 18, length_mm: 20}
                avoid: [lung]
                """);
        Path out = folder.resolve("out");
        CommandLineRun run =
                CommandLineRun.of("bench", "access", plan.toString(), "--maps", "1", "--out", out.toString());
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out()).contains("0 cross what their plan avoids").doesNotContain("NaN");
        assertThat(out.resolve("access.md")).content().doesNotContain("NaN");
        assertThat(out.resolve("access.json"))
                .content()
                .contains("\"in_reach\": 0")
                .doesNotContain("map_s_for_2000_points");
    }

    /** The bodies of the command are those that are measured. */
    @Test
    void imagingRefusesABodyAmongItsSettings() {
        CommandLineRun run = CommandLineRun.of(
                "bench", "imaging", "--set", "anatomy=virtual/adult-female", "--out", folder.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("found a key that each BODY of the command sets itself");
    }

    @Test
    void namesAnExerciseThatCannotBePlayedAndReportsTheOthers() throws IOException {
        Path body = Files.createDirectory(folder.resolve("no-body"));
        String plan = "data/exercises/1-large-target.yaml";
        Path out = folder.resolve("out");
        CommandLineRun run = CommandLineRun.of(
                "bench", "access", plan, "--maps", "0", "--set", "anatomy=" + body, "--out", out.toString());
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(run.out()).contains("not played: ", "no mesh has the name of a structure", "1 exercises could not");
        assertThat(out.resolve("access.md")).content().contains("Not played");
        assertThat(out.resolve("access.json")).content().contains("\"passes\": false", "\"not_played\": [");
    }
}
