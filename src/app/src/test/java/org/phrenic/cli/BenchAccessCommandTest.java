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
    void namesAnExerciseThatCannotBePlayedAndReportsTheOthers() throws IOException {
        Path body = Files.createDirectory(folder.resolve("no-body"));
        Path plan = folder.resolve("plan.yaml");
        String shipped = Files.readString(Path.of("data/exercises/1-large-target.yaml"));
        Files.writeString(plan, shipped);
        Path out = folder.resolve("out");
        CommandLineRun run = CommandLineRun.of(
                "bench", "access", plan.toString(), "--maps", "0", "--set", "anatomy=" + body, "--out", out.toString());
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(run.out()).contains("not played: ", "no mesh has the name of a structure", "1 exercises could not");
        assertThat(out.resolve("access.md")).content().contains("Not played");
        assertThat(out.resolve("access.json")).content().contains("\"passes\": false", "\"not_played\": [");
    }
}
