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
