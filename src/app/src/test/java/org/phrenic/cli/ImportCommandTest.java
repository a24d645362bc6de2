package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.patient.ScanSamples;

/** {@code phrenic import} and {@code phrenic info} on a small volume of two lungs and a liver. */
class ImportCommandTest {
    @TempDir
    private Path folder;

    private Path volume;
    private Path map;

    @BeforeEach
    void write() throws IOException {
        String header = "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: "
                + ScanSamples.COLUMNS + " " + ScanSamples.ROWS + " " + ScanSamples.SLICES
                + "\nspace directions: (4,0,0) (0,4,0) (0,0,4)\nencoding: raw\n"
                + "Segment0_Name:=lungs\nSegment0_LabelValue:=1\nSegment1_Name:=liver\nSegment1_LabelValue:=5\n\n";
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(header.getBytes(StandardCharsets.UTF_8));
        bytes.write(ScanSamples.voxels());
        volume = Files.write(folder.resolve("scan.seg.nrrd"), bytes.toByteArray());
        map = Files.writeString(folder.resolve("map.csv"), "label,structure\n1,lungs\n5,ignore\n");
    }

    /** A case of a data set: the scan, and its labels in a folder beside it. */
    @Test
    void theFolderOfACaseIsImportedAndThatOfADataSetAsksForOne() throws IOException {
        Path labels = Files.createDirectories(folder.resolve("set/s0011/segmentations"));
        Files.move(volume, labels.resolve("organs.seg.nrrd"));
        Files.writeString(
                folder.resolve("set/s0011/ct.nrrd"),
                "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 1 1\n"
                        + "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: text\n\n-1000 40\n");
        Path out = folder.resolve("patient");
        CommandLineRun run = CommandLineRun.of(
                "import", labels.getParent().toString(), "--out", out.toString(), "--complete", "none", "--edge", "16");
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out()).contains("lung_R", "lung_L", "liver");
        Path elsewhere = Files.createDirectories(folder.resolve("all/derivatives"));
        Files.move(folder.resolve("set"), elsewhere.resolve("set"));
        CommandLineRun all = CommandLineRun.of(
                "import", folder.resolve("all").toString(), "--out", out.toString(), "--labels", "totalsegmentator");
        assertThat(all.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(all.err()).contains("expected the folder of one scan; phrenic import takes", "s0011 --out patient");
    }

    @Test
    void aFolderOfMeshesIsWrittenAndSaidWhatIsInIt() throws IOException {
        Path out = folder.resolve("patient");
        CommandLineRun run =
                CommandLineRun.of("import", volume.toString(), "--complete", "none", "--out", out.toString());
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out())
                .contains("lung_L", "lung_R", "liver", "rib_01_R to rib_12_R", "cannot breathe", Disclaimer.TEXT);
        assertThat(run.err()).contains("3 of 3 structures meshed");
        assertThat(out.resolve("lung_R.vtp")).exists();
        assertThat(Files.readString(out.resolve("thorax.yaml"))).contains("axes: LPS", "lung_R: lung_R.vtp");
        assertThat(Files.readString(out.resolve("import.json")))
                .contains("\"source\": \"scan\"", "off_label_mean_mm", "\"can_breathe\": false");
        OutputsPage.assertHasKeys("What an import leaves", out.resolve("import.json"));
    }

    /** What an import writes without a template has no diaphragm. */
    @Test
    void aBodyWithoutADiaphragmIsDescribedAndASecondScanIsAlignedToIt() {
        Path first = folder.resolve("first");
        CommandLineRun run = CommandLineRun.of(
                "import", volume.toString(), "--complete", "none", "--edge", "8", "--out", first.toString());
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        CommandLineRun info = CommandLineRun.of("info", first.toString());
        assertThat(info.exitCode()).as(info.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(info.out()).containsPattern("lung +2").containsPattern("missing\\R(    .*\\R)*    diaphragm\\R");
        CommandLineRun second = CommandLineRun.of(
                "import",
                volume.toString(),
                "--align-to",
                first.toString(),
                "--edge",
                "8",
                "--out",
                folder.resolve("second").toString(),
                "--json");
        assertThat(second.exitCode()).as(second.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(second.out()).contains("\"fixed_part\": \"apex and posterior medial surface of the lungs\"");
    }

    /** The scan without its names, in the form of nnU-Net: its data set names the labels. */
    @Test
    void namesOfADataSetBesideTheScanAreTakenAndSaid() throws IOException {
        Path file = folder.resolve("case_001.mha");
        ScanSamples.writeMha(file);
        Files.writeString(
                folder.resolve("dataset.json"), "{\"labels\": {\"background\": 0, \"lungs\": 1, \"liver\": 5}}");
        CommandLineRun info = CommandLineRun.of("info", file.toString());
        assertThat(info.out()).contains("5 liver", "dataset.json names the labels");
        CommandLineRun run = CommandLineRun.of(
                "import",
                file.toString(),
                "--complete",
                "none",
                "--edge",
                "16",
                "--out",
                folder.resolve("patient").toString());
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out()).contains("lung_R", "liver", "dataset.json names the labels");
        assertThat(run.out() + run.err()).containsOnlyOnce("dataset.json names the labels");
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"lungs\": 1}}");
        CommandLineRun refused = CommandLineRun.of(
                "import", file.toString(), "--out", folder.resolve("other").toString());
        assertThat(refused.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(refused.err())
                .contains("dataset.json is left aside: it has no name for label 5", "expected --labels");
    }

    @Test
    void aTableSaysWhichLabelsAreLeftOut() throws IOException {
        Path out = folder.resolve("two");
        Path table = Files.writeString(folder.resolve("some.csv"), "label,structure\n1,lungs\n5,ignore\n");
        CommandLineRun run = CommandLineRun.of(
                "import",
                volume.toString(),
                "--labels",
                table.toString(),
                "--out",
                out.toString(),
                "--json",
                "--complete",
                "none",
                "--edge",
                "8");
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out()).contains("\"structure\": \"lung_R\"").doesNotContain("\"structure\": \"liver\"");
    }

    @Test
    void infoSaysWhatAVolumeHolds() {
        CommandLineRun run = CommandLineRun.of("info", volume.toString());
        assertThat(run.exitCode()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out())
                .contains("label volume", "60  40  50", "1 lungs", "5 liver")
                .containsPattern("axes +LPS")
                .doesNotContain("contradicted");
    }

    @Test
    void badInputIsOneSentenceAndWritesNothing() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.csv"), "label,structure\n1,hart\n");
        Path text = Files.writeString(folder.resolve("text.nii"), "no volume");
        assertBad("line 2, column 'structure': found 'hart'", volume, "--labels", bad.toString());
        assertBad("no such file", folder.resolve("none.nii"), "--labels", map.toString());
        assertBad("348 or 540 bytes", text, "--labels", map.toString());
        assertBad("another ending", map, "--labels", map.toString());
        assertBad("--edge", volume, "--edge", "-1");
        assertBad("three letters", volume, "--axes", "up");
        assertBad("virtual/giant", volume, "--complete", "virtual/giant");
        Path meshes = Files.createDirectory(folder.resolve("meshes"));
        assertBad("a folder of meshes and --labels", meshes, "--labels", map.toString());
        assertBad("a folder of meshes and --labels, --axes, --spacing or --edge", meshes, "--edge", "3");
        CommandLineRun onto = CommandLineRun.of("import", meshes.toString(), "--out", meshes.toString());
        assertThat(onto.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(onto.err()).contains("found a folder that the command reads, expected another");
        CommandLineRun nowhere = CommandLineRun.of("import", volume.toString(), "--out", "");
        assertThat(nowhere.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(nowhere.err()).contains("found an empty name");
    }

    private void assertBad(String part, Path file, String... more) {
        String[] args = new String[4 + more.length];
        args[0] = "import";
        args[1] = file.toString();
        args[2] = "--out";
        args[3] = folder.resolve("nothing").toString();
        System.arraycopy(more, 0, args, 4, more.length);
        CommandLineRun run = CommandLineRun.of(args);
        assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.err().lines().reduce((first, last) -> last).orElseThrow())
                .startsWith("phrenic: ")
                .contains(part);
        assertThat(folder.resolve("nothing")).doesNotExist();
    }
}
