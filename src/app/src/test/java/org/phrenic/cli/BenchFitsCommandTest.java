package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;

class BenchFitsCommandTest {
    @TempDir
    Path folder;

    @Test
    void refusesToFitNothingAndFoldersWithoutPairsOfScans() {
        String out = folder.resolve("out").toString();
        CommandLineRun nothing = CommandLineRun.of("bench", "fits", "--out", out);
        assertThat(nothing.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(nothing.err()).contains("--patients nor --random");
        CommandLineRun empty = CommandLineRun.of("bench", "fits", "--patients", folder.toString(), "--out", out);
        assertThat(empty.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(empty.err()).contains("found no pair of volumes");
    }
}
