package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;

class BenchStabilityCommandTest {
    @TempDir
    Path folder;

    @Test
    void cellsAreToldPrintedAndWritten() {
        Path out = folder.resolve("out");
        CommandLineRun run = CommandLineRun.of(
                "bench",
                "stability",
                "--quick",
                "--only",
                "published,damping-0",
                "--integrator",
                "verlet,rk2",
                "--spend",
                "1e6",
                "--out",
                out.toString());
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.err()).contains("of 4 cells done: published, verlet: stable", "damping-0, rk2: refused (");
        assertThat(run.out()).contains("case", "verlet", "rk2", "0 FAILED SILENTLY");
        assertThat(out.resolve("stability.md")).content().contains("| damping-0 | stable");
        assertThat(out.resolve("stability.csv")).content().contains("published,verlet,stable");
        assertThat(out.resolve("stability.json")).content().contains("\"passes\": true");
    }

    /** Its settings are impossible, so that they are noticed is what the case asks for; nothing recovers. */
    @Test
    void linksThatContradictEachOtherAreNoticedAndEndTheRun() {
        CommandLineRun run = CommandLineRun.of(
                "bench", "stability", "--quick", "--only", "links-conflict", "--integrator", "verlet");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.err()).contains("links-conflict, verlet: noticed, stopped (", "off its length by 33 %");
        assertThat(run.out()).contains("0 recovered", "1 noticed, stopped").doesNotContain("ended before their time");
    }

    @Test
    void badInputGivesExitCode2InOneLine() {
        for (String[] bad : new String[][] {
            {"--only", "no-such"},
            {"--integrator", "euler"},
            {"--scan", "nowhere"},
            {"--made-by", "me"},
            {"--spend", "much"}
        }) {
            CommandLineRun run = CommandLineRun.of("bench", "stability", bad[0], bad[1]);
            assertThat(run.err()).contains("phrenic: " + bad[0]);
            assertThat(run.exitCode()).as(String.join(" ", bad)).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.err().lines()).as(run.err()).hasSize(1);
            assertThat(run.out()).isEmpty();
        }
    }
}
