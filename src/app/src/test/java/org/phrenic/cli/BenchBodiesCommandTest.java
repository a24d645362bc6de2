package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;

class BenchBodiesCommandTest {
    @TempDir
    Path folder;

    /** A body that cannot be loaded is a row of the report, so that the others are checked all the same. */
    @Test
    void bodyThatCannotBeLoadedIsAFindingOfTheReport() throws IOException {
        Path out = folder.resolve("out");
        Path empty = Files.createDirectory(folder.resolve("empty"));
        CommandLineRun run =
                CommandLineRun.of("bench", "bodies", empty.toString(), "--out", out.toString(), "--made-by", "A test");
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(run.out()).contains("1 bodies: 0 breathe");
        assertThat(out.resolve("bodies.md")).content().contains("no mesh has the name of a structure", "- A test");
        assertThat(out.resolve("bodies.html")).exists();
        assertThat(out.resolve("bodies.json")).content().contains("\"passes\": false");
    }

    @Test
    void badInputGivesExitCode2() {
        for (String[] bad : new String[][] {
            {},
            {"--random", "-1"},
            {"--random", "1", "--set", "preset=quiet"},
            {"--random", "1", "--set", "threads=2"},
            {"--random", "1", "--pictures"},
            {"--random", "1", "--complete", "virtual/adult-female"},
            {"one/scan.nii", "two/scan.nii", "--out", folder.resolve("out").toString()}
        }) {
            String[] args = new String[bad.length + 2];
            args[0] = "bench";
            args[1] = "bodies";
            System.arraycopy(bad, 0, args, 2, bad.length);
            CommandLineRun run = CommandLineRun.of(args);
            assertThat(run.exitCode()).as(String.join(" ", bad)).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.out()).isEmpty();
        }
    }
}
