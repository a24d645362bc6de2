package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.mesh.io.volume.NiftiWriter;
import org.phrenic.mesh.voxel.LabelGrid;

class BenchImportCommandTest {
    @ParameterizedTest
    @CsvSource({"--size, 512x512", "--size, 8x512x512", "--heap, much"})
    void badInputIsOneSentence(String option, String value) {
        CommandLineRun run = CommandLineRun.of("bench", "import", "scan.nii.gz", "--size", "64x64x64", option, value);
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains(option).contains(value);
    }

    /** Labels without a bone, a lung or a liver in places that people have: the import says that it does not know. */
    @Test
    void whatTheImportRefusesIsRefusedWithItsSentence(@TempDir Path folder) throws IOException {
        byte[] labels = new byte[32 * 32 * 32];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) (v % 5);
        }
        Path scan = folder.resolve("noise.nii.gz");
        double[] toMm = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
        NiftiWriter.write(scan, LabelGrid.of(32, 32, 32, labels, toMm));
        CommandLineRun run = CommandLineRun.of(
                "bench",
                "import",
                scan.toString(),
                "--size",
                "20x20x20",
                "--out",
                folder.resolve("out").toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("20 x 20 x 20").contains("interpolated linearly");
        assertThat(Files.exists(folder.resolve("out"))).isFalse();
    }
}
