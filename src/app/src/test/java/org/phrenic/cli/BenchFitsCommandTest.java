package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
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

    @Test
    void namesPatientsOfWhomOneScanIsMissing() throws IOException {
        for (String scan : new String[] {"anna_expiration.nii.gz", "anna_inspiration.mha", "berta_expiration.nii.gz"}) {
            Files.writeString(folder.resolve(scan), "no scan");
        }
        String out = folder.resolve("out").toString();
        CommandLineRun run = CommandLineRun.of("bench", "fits", "--patients", folder.toString(), "--out", out);
        assertThat(run.exitCode()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(run.out()).contains("not fitted: anna: ", "found no berta_inspiration.* beside it", "2 not fitted");
    }

    @Test
    void namesPatientsWhoseScansCannotBeUsedAndGoesOn() throws IOException {
        for (String name : new String[] {"anna", "berta"}) {
            Files.writeString(folder.resolve(name + "_expiration.nii.gz"), "no scan");
            Files.writeString(folder.resolve(name + "_inspiration.nii.gz"), "no scan");
        }
        Path out = folder.resolve("out");
        CommandLineRun run =
                CommandLineRun.of("bench", "fits", "--patients", folder.toString(), "--out", out.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(run.out()).contains("not fitted: anna: ", "not fitted: berta: ", "2 not fitted");
        assertThat(out.resolve("fits.md")).content().contains("anna", "berta\\_expiration.nii.gz");
        assertThat(out.resolve("fits.json")).content().contains("\"not_fitted\": [");
    }

    @Test
    void helpStatesTheExitCodeOfAPatientWhoIsNotFitted() {
        assertThat(CommandLineRun.of("bench", "fits", "--help").out())
                .contains("Exit code 3 if a fit ends without a result or a patient could not be fitted.");
    }
}
