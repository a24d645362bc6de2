package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;

class RegressCommandTest {
    @TempDir
    Path folder;

    private CommandLineRun run(String... more) {
        String[] all = {"regress", "--scene", "changed"};
        String[] args = java.util.Arrays.copyOf(all, all.length + more.length);
        System.arraycopy(more, 0, args, all.length, more.length);
        return CommandLineRun.of(args);
    }

    @Test
    void referencesAreWrittenComparedAndMissed() throws IOException {
        String here = folder.toString();
        CommandLineRun written = run("--write-references", here);
        assertThat(written.exitCode()).as(written.err()).isZero();
        Path file = folder.resolve("changed.yaml");
        CommandLineRun held = run("--references", here, "--json");
        assertThat(held.exitCode()).isZero();
        assertThat(held.out()).contains("\"passes\": true", "\"scene\": \"changed\"", "\"worst_node\"");
        // The first coordinate of the first frame moved by 1 mm.
        String text = Files.readString(file);
        int at = text.indexOf("positions_um: ") + "positions_um: ".length();
        long first = Long.parseLong(text.substring(at, text.indexOf(' ', at)));
        Files.writeString(file, text.substring(0, at) + (first + 1000) + text.substring(text.indexOf(' ', at)));
        CommandLineRun missed = run("--references", here);
        assertThat(missed.exitCode()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(missed.out()).contains("OFF", "mm from its reference at 0.400 s", "failed");
        // Cut off in the middle.
        Files.writeString(file, text.substring(0, text.length() / 2));
        CommandLineRun cut = run("--references", here);
        assertThat(cut.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(cut.err().lines()).as(cut.err()).hasSize(1);
    }

    @Test
    void badInputGivesExitCode2InOneLine() {
        for (String[] bad : new String[][] {
            {"--scene", "no-such"},
            {"--references", folder.resolve("none").toString()},
            {"--references", folder.toString(), "--write-references", folder.toString()},
            {"--scene", "changed", "--write-references", folder.toString(), "--json"},
        }) {
            CommandLineRun run = CommandLineRun.of(concat("regress", bad));
            assertThat(run.exitCode()).as(String.join(" ", bad)).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.err().lines()).as(run.err()).hasSize(1);
            assertThat(run.out()).isEmpty();
        }
    }

    private static String[] concat(String first, String[] more) {
        String[] all = new String[more.length + 1];
        all[0] = first;
        System.arraycopy(more, 0, all, 1, more.length);
        return all;
    }
}
