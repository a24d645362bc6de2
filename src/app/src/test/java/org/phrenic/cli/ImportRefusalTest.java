package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.mesh.io.volume.VolumeSamples;
import org.phrenic.patient.ScanSamples;

/**
 * {@code phrenic import} of a volume that cannot be used: exit code 2, one sentence, no folder; of one that looks odd:
 * a folder and a note.
 */
class ImportRefusalTest {
    private static final ByteOrder LITTLE = ByteOrder.LITTLE_ENDIAN;
    private static final byte[] VOXELS = VolumeSamples.voxels(2, LITTLE, 1);

    @TempDir
    private Path folder;

    private static Arguments bad(String what, String expected, String name, byte[] content) {
        return Arguments.of(what, expected, name, content);
    }

    private static byte[] nifti(Consumer<ByteBuffer> change) {
        return VolumeSamples.nifti(2, LITTLE, change);
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] cut(byte[] content, int length) {
        return Arrays.copyOf(content, length);
    }

    private static byte[] nrrd(String found, String put) {
        return VolumeSamples.join(VolumeSamples.nrrd("uchar", "raw").replace(found, put) + "\n", VOXELS);
    }

    private static byte[] meta(String found, String put) {
        return VolumeSamples.join(VolumeSamples.meta("MET_UCHAR", false).replace(found, put) + "LOCAL\n", VOXELS);
    }

    static Stream<Arguments> nifti() {
        byte[] packed = VolumeSamples.gzip(nifti(h -> {}));
        byte[] damaged = packed.clone();
        damaged[packed.length / 2] ^= 0x55;
        byte[] floats = VolumeSamples.join(
                cut(VolumeSamples.nifti(16, LITTLE, h -> {}), VolumeSamples.NIFTI_HEADER),
                VolumeSamples.voxels(16, LITTLE, 0.5));
        return Stream.of(
                bad("empty", "empty file", "a.nii", new byte[0]),
                bad("a single byte", "348 or 540 bytes", "a.nii", new byte[1]),
                bad("gzip: its magic alone", "expected", "a.nii.gz", cut(packed, 2)),
                bad("gzip cut in its header", "expected", "a.nii.gz", cut(packed, 9)),
                bad("gzip cut in the volume's header", "expected", "a.nii.gz", cut(packed, 60)),
                bad("gzip cut among voxels", "expected", "a.nii.gz", cut(packed, packed.length - 14)),
                bad("gzip cut in its checksum", "expected", "a.nii.gz", cut(packed, packed.length - 5)),
                bad("gzip with a changed byte", "expected", "a.nii.gz", damaged),
                bad("cut in the header", "348 or 540 bytes", "a.nii", cut(nifti(h -> {}), 200)),
                bad("cut among voxels", "19 bytes of voxels", "a.nii", cut(nifti(h -> {}), 371)),
                bad("no voxels", "0 bytes of voxels", "a.nii", cut(nifti(h -> {}), 352)),
                bad("two dimensions", "2 dimensions", "a.nii", nifti(h -> h.putShort(40, (short) 2))),
                bad("dimensions beyond all", "-7 dimensions", "a.nii", nifti(h -> h.putShort(40, (short) -7))),
                bad("four dimensions", "found 6 volumes", "a.nii", nifti(h -> {
                    h.putShort(40, (short) 4);
                    h.putShort(48, (short) 6);
                })),
                bad("no columns", "size of 0 x 3 x 2", "a.nii", nifti(h -> h.putShort(42, (short) 0))),
                bad("negative rows", "size of 4 x -3 x 2", "a.nii", nifti(h -> h.putShort(44, (short) -3))),
                bad("float labels", "found 0.5, expected a label", "a.nii", floats),
                bad("complex numbers", "datatype 32", "a.nii", nifti(h -> h.putShort(70, (short) 32))),
                bad("spacing zero", "spacing of 0 mm along slices", "a.nii", nifti(h -> h.putFloat(320, 0))),
                bad("spacing NaN", "not finite", "a.nii", nifti(h -> h.putFloat(320, Float.NaN))),
                bad("qform NaN", "not finite", "a.nii", nifti(h -> {
                    h.putShort(254, (short) 0);
                    h.putShort(252, (short) 1);
                    h.putFloat(256, Float.NaN);
                })),
                bad("sheared sform", "right angles", "a.nii", nifti(h -> h.putFloat(284, 1))),
                bad("magic", "no 'n+1'", "a.nii", nifti(h -> h.put(344, (byte) 'm'))),
                bad("header of a pair", "pair .hdr and .img", "a.nii", nifti(h -> h.put(345, (byte) 'i'))),
                bad("NIfTI-2 cut in the header", "348 or 540 bytes", "a.nii", nifti(h -> h.putInt(0, 540))),
                bad("voxels before the header's end", "byte 12", "a.nii", nifti(h -> h.putFloat(108, 12))),
                bad("voxels at no number", "byte 0", "a.nii", nifti(h -> h.putFloat(108, Float.NaN))),
                bad("voxels beyond the end", "bytes of voxels", "a.nii", nifti(h -> h.putFloat(108, 1e9f))),
                bad(
                        "voxels beyond the end, packed",
                        "expected",
                        "a.nii.gz",
                        VolumeSamples.gzip(nifti(h -> h.putFloat(108, 1e9f)))),
                bad("absurd sizes", "2^31", "a.nii.gz", VolumeSamples.gzip(nifti(h -> {
                    h.putShort(42, Short.MAX_VALUE);
                    h.putShort(44, Short.MAX_VALUE);
                    h.putShort(46, Short.MAX_VALUE);
                }))),
                bad("gigabytes promised", "2000 x 1000 x 1000", "a.nii", nifti(ImportRefusalTest::vast)),
                bad(
                        "gigabytes promised, packed",
                        "2000 x 1000 x 1000",
                        "a.nii.gz",
                        VolumeSamples.gzip(nifti(ImportRefusalTest::vast))));
    }

    private static void vast(ByteBuffer header) {
        header.putShort(42, (short) 2000);
        header.putShort(44, (short) 1000);
        header.putShort(46, (short) 1000);
    }

    static Stream<Arguments> nrrd() {
        byte[] packed = VolumeSamples.gzip(VOXELS);
        String gzip = VolumeSamples.nrrd("uchar", "gzip");
        return Stream.of(
                bad("magic", "NRRD000", "a.nrrd", nrrd("NRRD", "NERD")),
                bad("cut in the header", "line 3", "a.seg.nrrd", text("NRRD0004\ntype: uchar\ndimens")),
                bad("cut after the header", "end of the file", "a.nrrd", text(VolumeSamples.nrrd("uchar", "raw"))),
                bad("cut among voxels", "end after 19 voxels", "a.nrrd", cut(nrrd("", ""), nrrd("", "").length - 5)),
                bad("gzip cut", "expected", "a.nrrd", VolumeSamples.join(gzip + "\n", cut(packed, 12))),
                bad("no gzip", "damaged", "a.nrrd", VolumeSamples.join(gzip + "\n", new byte[40])),
                bad(
                        "two dimensions",
                        "2 dimensions",
                        "a.nrrd",
                        VolumeSamples.join(
                                VolumeSamples.nrrd("uchar", "raw")
                                                .replace("dimension: 3", "dimension: 2")
                                                .replace("4 3 2", "12 2")
                                        + "\n",
                                VOXELS)),
                bad(
                        "layers",
                        "found 2 volumes",
                        "a.seg.nrrd",
                        VolumeSamples.join(
                                VolumeSamples.nrrd("uchar", "raw")
                                                .replace("dimension: 3", "dimension: 4")
                                                .replace("4 3 2", "2 4 3 1")
                                                .replace("(-2", "none (-2")
                                        + "\n",
                                VOXELS)),
                bad("size zero", "size of 0 x 3 x 2", "a.nrrd", nrrd("4 3 2", "0 3 2")),
                bad("size no number", "'many'", "a.nrrd", nrrd("4 3 2", "many 3 2")),
                bad("absurd sizes", "2^31", "a.nrrd", nrrd("4 3 2", "2147483647 2147483647 2147483647")),
                bad("gigabytes promised", "bytes of voxels", "a.nrrd", nrrd("4 3 2", "2000 1000 1000")),
                bad("spacing zero", "0 mm along slices", "a.nrrd", nrrd("(0,0,4)", "(0,0,0)")),
                bad("spacing NaN", "'nan'", "a.nrrd", nrrd("(0,0,4)", "(0,0,nan)")),
                bad("sheared", "right angles", "a.nrrd", nrrd("(0,0,4)", "(0,2,4)")),
                bad("unknown space", "'scanner-xyz'", "a.nrrd", nrrd("right-anterior-superior", "scanner-xyz")),
                bad(
                        "unknown encoding",
                        "expected raw, gzip, bzip2 or ascii",
                        "a.nrrd",
                        nrrd("encoding: raw", "encoding: hex")),
                bad("no type", "no 'type'", "a.nrrd", nrrd("type: uchar\n", "")),
                bad("unknown type", "'block'", "a.nrrd", nrrd("type: uchar", "type: block")),
                bad(
                        "no byte order",
                        "endian",
                        "a.nrrd",
                        text(VolumeSamples.nrrd("short", "raw").replace("endian: little\n", "") + "\nxx")),
                bad("negative skip", "byte skip", "a.nrrd", nrrd("endian", "byte skip: -5\nendian")),
                bad(
                        "float labels",
                        "found 0.5",
                        "a.nrrd",
                        VolumeSamples.join(
                                VolumeSamples.nrrd("float", "raw") + "\n", VolumeSamples.voxels(16, LITTLE, 0.5))),
                bad(
                        "missing file of voxels",
                        "not there",
                        "a.nhdr",
                        text(VolumeSamples.nrrd("uchar", "raw") + "data file: none.raw\n\n")),
                bad(
                        "file of voxels outside all names",
                        "not there",
                        "a.nhdr",
                        text(VolumeSamples.nrrd("uchar", "raw") + "data file: \0\n\n")));
    }

    static Stream<Arguments> metaImage() {
        byte[] packed = VolumeSamples.zlib(VOXELS);
        String zlib = VolumeSamples.meta("MET_UCHAR", true) + "LOCAL\n";
        return Stream.of(
                bad("no header", "key = value", "a.mha", text("this is no header\n")),
                bad("cut in the header", "ElementDataFile", "a.mha", text("ObjectType = Image\nNDims = 3\n")),
                bad("cut among voxels", "end after 21 voxels", "a.mha", cut(meta("", ""), meta("", "").length - 3)),
                bad("zlib cut", "expected", "a.mha", VolumeSamples.join(zlib, cut(packed, packed.length - 8))),
                bad("no zlib", "damaged", "a.mha", VolumeSamples.join(zlib, new byte[30])),
                bad("two dimensions", "2 dimensions", "a.mha", meta("NDims = 3", "NDims = 2")),
                bad(
                        "four dimensions",
                        "found 5 volumes",
                        "a.mha",
                        text("NDims = 4\nDimSize = 4 3 2 5\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n")),
                bad("size zero", "size of 0 x 3 x 2", "a.mha", meta("4 3 2", "0 3 2")),
                bad("absurd sizes", "2^31", "a.mha", meta("4 3 2", "99999999 99999999 9999999")),
                bad("gigabytes promised", "bytes of voxels", "a.mha", meta("4 3 2", "2000 1000 1000")),
                bad("spacing zero", "0 mm along slices", "a.mha", meta("2 3 4", "2 3 0")),
                bad("spacing NaN", "'nan'", "a.mha", meta("2 3 4", "2 3 nan")),
                bad("two spacings", "2 numbers, expected 3", "a.mha", meta("2 3 4", "2 3")),
                bad("sheared", "right angles", "a.mha", meta("0 -1 0", "0.3 -1 0")),
                bad("colours", "3 values a voxel", "a.mha", meta("NDims", "ElementNumberOfChannels = 3\nNDims")),
                bad(
                        "text voxels",
                        "expected a number, as voxels are text by the header",
                        "a.mha",
                        meta("BinaryData = True", "BinaryData = False")),
                bad(
                        "float labels",
                        "found 0.5",
                        "a.mha",
                        VolumeSamples.join(
                                VolumeSamples.meta("MET_FLOAT", false) + "LOCAL\n",
                                VolumeSamples.voxels(16, LITTLE, 0.5))),
                bad(
                        "missing file of voxels",
                        "not there",
                        "a.mhd",
                        text(VolumeSamples.meta("MET_UCHAR", false) + "none.raw\n")));
    }

    private CommandLineRun imported(Path volume, String... more) {
        String[] args = {
            "import", volume.toString(), "--out", folder.resolve("out").toString()
        };
        return CommandLineRun.of(
                Stream.concat(Arrays.stream(args), Arrays.stream(more)).toArray(String[]::new));
    }

    /** The import of a volume with a table of labels of these rows. */
    private CommandLineRun labelled(Path volume, String... rows) throws IOException {
        return imported(volume, "--labels", table(rows).toString());
    }

    private Path table(String... rows) throws IOException {
        return Files.writeString(folder.resolve("labels.csv"), String.join("\n", rows) + "\n");
    }

    @ParameterizedTest(name = "{2}: {0}")
    @MethodSource({"nifti", "nrrd", "metaImage"})
    void isToldInOneSentenceAndNothingIsWritten(String what, String expected, String name, byte[] content)
            throws IOException {
        Path volume = Files.write(folder.resolve(name), content);
        CommandLineRun run = labelled(volume, "label,structure", "1,lungs");
        assertRefused(run, expected);
        assertThat(run.err()).contains(name);
    }

    private void assertRefused(CommandLineRun run, String expected) {
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(run.out()).isEmpty();
        // Lines of progress come first; the refusal is one line and the last.
        assertThat(run.err().lines().filter(line -> line.startsWith("phrenic: ")))
                .as(run.err())
                .hasSize(1);
        assertThat(run.err().lines().reduce((first, last) -> last).orElseThrow())
                .startsWith("phrenic: ")
                .contains("expected", expected)
                .doesNotContain("Exception");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    /** The sample scan as NIfTI with the given voxels of 16 bits, in LPS by the sform. */
    private Path scan(ByteOrder order, byte[] labels, double... spacing) throws IOException {
        byte[] header = VolumeSamples.nifti(4, order, h -> {
            h.putShort(42, (short) ScanSamples.COLUMNS);
            h.putShort(44, (short) ScanSamples.ROWS);
            h.putShort(46, (short) ScanSamples.SLICES);
            float[] rows = {(float) -spacing[0], 0, 0, 0, 0, (float) -spacing[1], 0, 0, 0, 0, (float) spacing[2], 0};
            for (int i = 0; i < 12; i++) {
                h.putFloat(280 + 4 * i, rows[i]);
            }
        });
        ByteBuffer data = ByteBuffer.allocate(2 * labels.length).order(order);
        for (byte label : labels) {
            data.putShort(label);
        }
        return Files.write(
                folder.resolve("scan.nii"), VolumeSamples.join(cut(header, VolumeSamples.NIFTI_HEADER), data.array()));
    }

    private static byte[] relabelled(int from, int to) {
        byte[] labels = ScanSamples.voxels();
        for (int v = 0; v < labels.length; v++) {
            labels[v] = labels[v] == from ? (byte) to : labels[v];
        }
        return labels;
    }

    private String noted(Path volume, String... rows) throws IOException {
        CommandLineRun run = imported(volume, "--labels", table(rows).toString(), "--complete", "none", "--edge", "16");
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        // What is said is in the report of the folder as well.
        String notes = YamlDocument.read(folder.resolve("out").resolve("import.json")).texts("notes").stream()
                .map(note -> note + ".\n")
                .collect(Collectors.joining());
        assertThat(run.out())
                .endsWith("it takes a diaphragm and ribs.\n" + notes + "\n" + Disclaimer.TEXT + System.lineSeparator());
        return run.out();
    }

    @Test
    void eitherByteOrderIsRead() throws IOException {
        byte[] labels = ScanSamples.voxels();
        String little = noted(scan(LITTLE, labels, 4, 4, 4), "label,structure", "1,lungs");
        String big = noted(scan(ByteOrder.BIG_ENDIAN, labels, 4, 4, 4), "label,structure", "1,lungs");
        assertThat(big).isEqualTo(little).contains("lung_R", "lung_L");
    }

    @ParameterizedTest
    @CsvSource({
        "'', labels.csv",
        "'label,structure', labels.csv",
        "'label,structure;1,hart', '''hart'''",
        "'label,structure;9,liver', 'found labels 1, 5 and none of the 1 labels asked for'"
    })
    void aTableThatDoesNotFitTheVolumeIsRefused(String rows, String expected) throws IOException {
        assertRefused(labelled(scan(LITTLE, ScanSamples.voxels(), 4, 4, 4), rows.split(";", -1)), expected);
    }

    @Test
    void aVolumeWithoutATableIsRefused() throws IOException {
        CommandLineRun run = imported(scan(LITTLE, ScanSamples.voxels(), 4, 4, 4));
        assertRefused(run, "labels 1, 5 without names");
        assertThat(run.err()).as("the template without --complete").contains("loading virtual/adult-male");
    }

    @Test
    void aTableThatFitsInPartIsNoted() throws IOException {
        assertThat(noted(scan(LITTLE, ScanSamples.voxels(), 4, 4, 4), "label,structure", "1,lungs", "9,rib_01_R"))
                .contains("has none of these structures of the table: label 9 (rib_01_R)")
                .contains("kept as obstacles: other_5");
    }

    @Test
    void aVolumeOfBackground() throws IOException {
        Path scan = scan(LITTLE, new byte[ScanSamples.voxels().length], 4, 4, 4);
        assertRefused(labelled(scan, "label,structure", "1,lungs"), "background alone");
    }

    @Test
    void aLiverAloneIsCompletedFromTheTemplate() throws IOException {
        Path scan = scan(LITTLE, ScanSamples.voxels(), 4, 4, 4);
        CommandLineRun run = imported(
                scan,
                "--labels",
                table("label,structure", "5,liver", "1,ignore").toString(),
                "--edge",
                "16");
        assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(run.out()).contains("missing: nothing").doesNotContain("cannot breathe");
        assertThat(Files.readString(folder.resolve("out").resolve("thorax.yaml")))
                .contains("not_in_scan", "- lung_R")
                .doesNotContain("- liver");
    }

    @Test
    void mirroredLungsAreRemarkedOn() throws IOException {
        // Columns of the sample run to the left, and its right lung is the larger.
        assertThat(noted(scan(LITTLE, ScanSamples.voxels(), -4, 4, 4), "label,structure", "1,lungs"))
                .contains("the left lung is larger than the right", "--axes");
    }

    @Test
    void exchangedLabelsAreRefusedUnlessAxesAreStated() throws IOException {
        byte[] labels = ScanSamples.voxels();
        for (int v = 0; v < labels.length; v++) {
            labels[v] = labels[v] != ScanSamples.LUNGS ? 0 : (byte) (v % ScanSamples.COLUMNS < 30 ? 1 : 2);
        }
        Path exchanged = scan(LITTLE, labels, 4, 4, 4);
        String[] table = {"label,structure", "1,lung_L", "2,lung_R"};
        assertRefused(
                labelled(exchanged, table),
                "structures lie as in people if columns, rows and slices run to RPS, where the file states LPS (or"
                        + " labels of right and left are exchanged); expected --axes RPS, or --axes LPS to keep them");
        CommandLineRun kept =
                imported(exchanged, "--labels", table(table).toString(), "--complete", "none", "--axes", "LPS");
        assertThat(kept.exitCode()).as(kept.err()).isEqualTo(ExitCode.SUCCESS);
        assertThat(kept.out()).contains("the right lung lies on the left of the left one");
    }

    @Test
    void lungsOfImplausibleShapeOrSizeAreRemarkedOn() throws IOException {
        byte[] labels = relabelled(ScanSamples.LIVER, 0);
        // 26 rows of 4 mm deep, 36 slices tall.
        assertThat(noted(scan(LITTLE, labels, 4, 4, 4), "label,structure", "1,lungs"))
                .doesNotContain("--spacing");
        assertThat(noted(scan(LITTLE, labels, 4, 4, 8), "label,structure", "1,lungs"))
                .contains("mm tall and", "1.1 to 1.8 times as tall as deep", "--spacing");
        assertThat(noted(scan(LITTLE, labels, 1, 1, 1), "label,structure", "1,lungs"))
                .contains("people's hold 150 to 5000 ml");
    }
}
