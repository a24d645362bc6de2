package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
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

    /** Days of measurement are not lost with a sheet of pictures that cannot be made. */
    @Test
    void aReportWithoutPicturesIsWrittenWhereNoBodyHasAny() throws IOException {
        Path out = folder.resolve("out");
        Path empty = Files.createDirectory(folder.resolve("empty"));
        CommandLineRun run =
                CommandLineRun.of("bench", "bodies", empty.toString(), "--pictures", "--out", out.toString());
        assumeThat(run.exitCode()).as("something here draws").isNotEqualTo(ExitCode.NO_GRAPHICS);
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(run.out()).contains("1 bodies: 0 breathe");
        assertThat(out.resolve("bodies.csv")).exists();
        assertThat(out.resolve("bodies.png")).doesNotExist();
    }

    /** Bodies are written into a folder of the report, where they may not take the place of what they are made of. */
    @Test
    void meshesThatAreReadAreNotWrittenOver() throws IOException {
        Path out = folder.resolve("study");
        Path scan = Files.createDirectories(out.resolve("scans/p1"));
        Path mesh = Files.writeString(scan.resolve("liver.stl"), "of a patient");
        Path whole = Files.createDirectories(out.resolve("scans/p2-whole"));
        Files.writeString(whole.resolve("diaphragm.stl"), "of a patient");
        Path source = Files.createDirectories(folder.resolve("p2"));
        Files.writeString(source.resolve("diaphragm.stl"), "of a patient");
        for (String[] bad :
                new String[][] {{scan.toString()}, {source.toString(), whole.toString(), "--cuts", "whole"}}) {
            CommandLineRun run = bodies(bad, "--out", out.toString());
            assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.err()).contains("found a folder that the command reads, expected another");
        }
        assertThat(mesh).hasContent("of a patient");
        assertThat(scan.resolve("thorax.yaml")).doesNotExist();
    }

    /** What import takes is a scan here as well. */
    @Test
    void aPhaseOfAFileAndMasksOfADiaphragmAreScans() throws IOException {
        Path out = folder.resolve("out");
        Path file = Files.writeString(folder.resolve("m.nii.gz"), "damaged");
        Path masks = Files.createDirectory(folder.resolve("masks"));
        Files.writeString(masks.resolve("diaphragm.nii.gz"), "damaged");
        CommandLineRun run = bodies(new String[] {file + "#1", masks.toString()}, "--out", out.toString());
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(out.resolve("bodies.json"))
                .content()
                .contains("\"m-1\"", "scan m.nii.gz#1", "\"masks\"", "scan masks");
    }

    @Test
    void whatHasNoEffectOrIsNotThereIsRefusedInOneSentence() throws IOException {
        String scan = Files.writeString(folder.resolve("s.nii"), "damaged").toString();
        String out = folder.resolve("out").toString();
        assertThat(bodies(new String[] {scan, "--cuts", "whole"}, "--out", out).err())
                .contains("--cuts whole: found scans alone, expected a body that is no scan");
        assertThat(bodies(new String[] {scan, "virtual/adult-male", "--cuts", "bogus"}, "--out", out)
                        .err())
                .contains("--cuts: found 'bogus'");
        assertThat(bodies(new String[] {scan, "--seed", "2"}, "--out", out).err())
                .contains("--seed 2: found it without --random, expected both");
        assertThat(bodies(new String[] {"typo.nii.gz"}, "--out", out).err())
                .contains("typo.nii.gz: found no such file, expected a body");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    /** Both would be written to the same folder. */
    @Test
    void twoScansOfOneNameAreRefused() throws IOException {
        String[] scans = new String[2];
        for (int i = 0; i < scans.length; i++) {
            Path patient = Files.createDirectory(folder.resolve("patient" + i));
            scans[i] = Files.writeString(patient.resolve("scan.nii"), "damaged").toString();
        }
        Path out = folder.resolve("out");
        CommandLineRun run = bodies(scans, "--out", out.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err()).contains("found two bodies named scan");
        assertThat(out).doesNotExist();
    }

    private static CommandLineRun bodies(String[] options, String... more) {
        return CommandLineRun.of(Stream.of(new String[] {"bench", "bodies"}, options, more)
                .flatMap(Stream::of)
                .toArray(String[]::new));
    }

    @Test
    void badInputGivesExitCode2() {
        for (String[] bad : new String[][] {
            {},
            {"--random", "-1"},
            {"--random", "1", "--set", "preset=quiet"},
            {"--random", "1", "--set", "threads=2"},
            {"--random", "1", "--pictures"},
            {"--random", "1", "--complete", "virtual/adult-female"}
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
