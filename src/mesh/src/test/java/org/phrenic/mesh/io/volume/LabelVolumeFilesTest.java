package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

/** One small volume in every format, type and byte order: labels, places and names come out the same. */
class LabelVolumeFilesTest {
    private static final double SINGLE_MM = 1e-5;
    private static final ByteOrder LITTLE = ByteOrder.LITTLE_ENDIAN;
    private static final ByteOrder BIG = ByteOrder.BIG_ENDIAN;

    @TempDir
    private Path folder;

    private LabelVolume read(String name, byte[] content) {
        return LabelVolumeFiles.read(VolumeSamples.write(folder, name, content));
    }

    /** Columns run to the patient's right... in LPS the sample's voxels step by (2, 0, 0), (0, -3, 0), (0, 0, 4). */
    private static void assertIsSample(LabelVolume volume) {
        LabelGrid grid = volume.grid();
        assertThat(new int[] {grid.columns(), grid.rows(), grid.slices()}).containsExactly(4, 3, 2);
        for (int v = 0; v < grid.voxelCount(); v++) {
            assertThat(grid.label(v)).isEqualTo(v);
        }
        double[] place = new double[3];
        grid.voxelToMm(0, 0, 0, place);
        assertThat(place).containsExactly(new double[] {-10, -20, 30}, within(SINGLE_MM));
        grid.voxelToMm(1, 1, 1, place);
        assertThat(place).containsExactly(new double[] {-8, -23, 34}, within(SINGLE_MM));
        assertThat(grid.isMirrored()).isTrue();
        assertThat(grid.voxelVolume()).isCloseTo(24, within(SINGLE_MM));
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 8, 16, 64, 256, 512, 768, 1024, 1280})
    void niftiOfEveryTypeInBothByteOrdersPlainAndPacked(int datatype) {
        for (ByteOrder order : new ByteOrder[] {LITTLE, BIG}) {
            byte[] file = VolumeSamples.nifti(datatype, order, h -> {});
            assertIsSample(read("plain.nii", file));
            assertIsSample(read("packed.nii.gz", VolumeSamples.gzip(file)));
            assertIsSample(read("misnamed.nii", VolumeSamples.gzip(file)));
        }
    }

    @Test
    void withoutSformTheQformPlacesVoxelsTurnedAndMirrored() {
        // Half a turn about y puts columns to the left and slices down; qfac -1 turns the slices back up.
        LabelVolume volume = read("q.nii", VolumeSamples.nifti(2, LITTLE, h -> {
            h.putShort(254, (short) 0);
            h.putShort(252, (short) 1);
            h.putFloat(76, -1);
            h.putFloat(260, 1);
            h.putFloat(268, 10);
            h.putFloat(272, 20);
            h.putFloat(276, 30);
        }));
        assertIsSample(volume);
    }

    /** The standard's order of preference (NIfTI-1, method 3 before method 2). */
    @Test
    void withBothFormsTheSformPlacesVoxels() {
        // A half turn about y with qfac -1, as the sform has it; the second qform lies 4 mm farther to the right.
        Consumer<ByteBuffer> same = h -> {
            h.putShort(252, (short) 1);
            h.putFloat(76, -1);
            h.putFloat(260, 1);
            h.putFloat(268, 10);
            h.putFloat(272, 20);
            h.putFloat(276, 30);
        };
        LabelVolume volume = read("both.nii", VolumeSamples.nifti(2, LITTLE, same));
        assertIsSample(volume);
        assertThat(volume.notes()).isEmpty();
        LabelVolume apart = read("apart.nii", VolumeSamples.nifti(2, LITTLE, same.andThen(h -> h.putFloat(268, 14))));
        assertIsSample(apart);
        assertThat(apart.notes())
                .containsExactly("sform and qform place voxels up to 4.0 mm apart: the sform was taken");
    }

    @Test
    void obliqueQformIsARotation() {
        double half = Math.toRadians(15);
        LabelGrid grid = read("oblique.nii", VolumeSamples.nifti(2, BIG, h -> {
                    h.putShort(254, (short) 0);
                    h.putShort(252, (short) 1);
                    h.putFloat(264, (float) Math.sin(half));
                }))
                .grid();
        double[] at = new double[3];
        grid.voxelToMm(1, 0, 0, at);
        // 30 degrees about z: columns of 2 mm run to (cos, sin) of RAS, so to minus that in LPS.
        assertThat(at)
                .containsExactly(new double[] {-2 * Math.cos(2 * half), -2 * Math.sin(2 * half), 0}, within(SINGLE_MM));
    }

    /** The sample in metres, millimetres and micrometres: places of 10 to 30 and steps of 2 to 4 of each unit. */
    @ParameterizedTest
    @CsvSource({"1, 1000", "2, 1", "3, 0.001"})
    void spaceIsInTheUnitOfTheHeader(byte unit, double mm) {
        LabelGrid grid = read("unit.nii", VolumeSamples.nifti(2, LITTLE, h -> h.put(123, unit)))
                .grid();
        double[] place = new double[3];
        grid.voxelToMm(0, 0, 0, place);
        assertThat(place).containsExactly(new double[] {-10 * mm, -20 * mm, 30 * mm}, within(SINGLE_MM * mm));
        grid.voxelToMm(1, 1, 1, place);
        assertThat(place).containsExactly(new double[] {-8 * mm, -23 * mm, 34 * mm}, within(SINGLE_MM * mm));
    }

    @Test
    void aFourthDimensionOfOneVolumeUnitsAndScalingAreHonoured() {
        byte[] file = VolumeSamples.nifti(16, LITTLE, h -> {
            h.putShort(40, (short) 4);
            h.put(123, (byte) 3);
            h.putFloat(112, 2);
            h.putFloat(116, 1);
        });
        LabelGrid grid = read("micrometres.nii", file).grid();
        assertThat(grid.label(5)).isEqualTo(11);
        assertThat(grid.spacing(0)).isCloseTo(2e-3, within(SINGLE_MM));
    }

    @Test
    void aZeroSformDoesNotHideTheQform() {
        LabelVolume volume = read("zero.nii", VolumeSamples.nifti(2, LITTLE, h -> {
            for (int at = 280; at < 328; at += Float.BYTES) {
                h.putFloat(at, 0);
            }
            h.putShort(252, (short) 1);
        }));
        assertThat(volume.notes()).containsExactly("the sform is zero: the qform was taken");
        assertThat(volume.grid().spacing(0)).isCloseTo(2, within(SINGLE_MM));
    }

    private static void clear(ByteBuffer header, int from, int to) {
        for (int at = from; at < to; at += Float.BYTES) {
            header.putFloat(at, 0);
        }
    }

    /** So that a spacing that is stated apart from the file has something to replace. */
    @Test
    void withoutASpacingVoxelsAreTakenToBe1MmWideWithANote() {
        String nrrd = VolumeSamples.nrrd("uchar", "raw")
                .replace("space: right-anterior-superior\n", "")
                .replace("space directions: (-2,0,0) (0,3,0) (0,0,4)\n", "")
                .replace("space origin: (10,20,30)\n", "");
        Map<String, byte[]> files = Map.of(
                "spaceless.nrrd",
                VolumeSamples.join(nrrd + "\n", VolumeSamples.voxels(2, LITTLE, 1)),
                "unknown.nrrd",
                VolumeSamples.join(nrrd + "spacings: nan NaN nan\n\n", VolumeSamples.voxels(2, LITTLE, 1)),
                "no-form.nii",
                VolumeSamples.nifti(2, LITTLE, h -> {
                    h.putShort(254, (short) 0);
                    clear(h, 80, 92);
                }),
                "qform-in-metres.nii",
                VolumeSamples.nifti(2, LITTLE, h -> {
                    h.putShort(254, (short) 0);
                    h.putShort(252, (short) 1);
                    h.put(123, (byte) 1);
                    clear(h, 80, 92);
                }));
        files.forEach((name, file) -> {
            LabelVolume volume = read(name, file);
            assertThat(volume.notes())
                    .as(name)
                    .contains("no spacing along columns, rows, slices: voxels were taken to be 1 mm wide there");
            for (int direction = 0; direction < 3; direction++) {
                assertThat(volume.grid().spacing(direction)).as(name).isCloseTo(1, within(SINGLE_MM));
            }
        });
        byte[] flat = VolumeSamples.nifti(2, LITTLE, h -> {
            h.putShort(254, (short) 0);
            clear(h, 88, 92);
        });
        LabelVolume slices = read("slices.nii", flat);
        assertThat(slices.notes()).contains("no spacing along slices: voxels were taken to be 1 mm wide there");
        assertThat(slices.grid().spacing(1)).isCloseTo(3, within(SINGLE_MM));
        LabelVolume zero = read("zero-sform.nii", VolumeSamples.nifti(2, LITTLE, h -> clear(h, 280, 328)));
        assertThat(zero.notes()).singleElement().asString().contains("neither sform nor qform");
        assertThat(zero.grid().spacing(1)).as("pixdim").isCloseTo(3, within(SINGLE_MM));
    }

    /** A mask of 0 and 1 that is stored as 0 and 255; half of 255 is no label. */
    @Test
    void aSlopeInSinglePrecisionGivesWholeLabels() {
        byte[] file = VolumeSamples.nifti(2, LITTLE, h -> h.putFloat(112, 1f / 255));
        for (int v = 0; v < VolumeSamples.VOXELS; v++) {
            file[VolumeSamples.NIFTI_HEADER + v] = (byte) (v % 2 == 0 ? 255 : 0);
        }
        LabelGrid grid = read("scaled.nii", file).grid();
        assertThat(grid.label(4)).isEqualTo(1);
        assertThat(grid.label(5)).isZero();
        file[VolumeSamples.NIFTI_HEADER] = (byte) 128;
        assertThatThrownBy(() -> read("scaled.nii", file))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 0.50");
    }

    @Test
    void withNeitherFormANoteSaysHowItWasTaken() {
        LabelVolume volume = read("none.nii", VolumeSamples.nifti(2, LITTLE, h -> h.putShort(254, (short) 0)));
        assertThat(volume.notes()).singleElement().asString().contains("neither sform nor qform");
        double[] place = new double[3];
        volume.grid().voxelToMm(1, 1, 1, place);
        assertThat(place)
                .as("to the right, to the front, up")
                .containsExactly(new double[] {-2, -3, 4}, within(SINGLE_MM));
        volume.grid().voxelToMm(0, 0, 0, place);
        assertThat(place).containsExactly(new double[3], within(SINGLE_MM));
    }

    @Test
    void namesComeFromTheLabelTableOfAnExtension() {
        String table = "<LabelTable>\n<Label Key=\"3\" Red=\"0.1\" Alpha=\"1\"><![CDATA[liver]]></Label>"
                + "<Label Key=\"7\" Red=\"0\">lung left</Label>"
                + "<Label Key=\"9\">Heart &amp; vessels &lt;1&gt;</Label></LabelTable>";
        byte[] plain =
                VolumeSamples.nifti(2, LITTLE, h -> h.putFloat(108, VolumeSamples.NIFTI_HEADER + table.length()));
        byte[] file = ByteBuffer.allocate(plain.length + table.length())
                .put(plain, 0, VolumeSamples.NIFTI_HEADER)
                .put(table.getBytes(StandardCharsets.UTF_8))
                .put(plain, VolumeSamples.NIFTI_HEADER, plain.length - VolumeSamples.NIFTI_HEADER)
                .array();
        LabelVolume volume = read("named.nii.gz", VolumeSamples.gzip(file));
        assertIsSample(volume);
        assertThat(volume.names()).containsEntry(3, "liver").containsEntry(7, "lung left");
        assertThat(volume.names()).containsEntry(9, "Heart & vessels <1>");
    }

    @Test
    void nrrdRawGzipBzip2BothByteOrdersAndDetached() {
        byte[] shorts = VolumeSamples.voxels(4, LITTLE, 1);
        assertIsSample(read("raw.nrrd", VolumeSamples.join(VolumeSamples.nrrd("short", "raw") + "\n", shorts)));
        assertIsSample(read(
                "packed.seg.nrrd",
                VolumeSamples.join(VolumeSamples.nrrd("short", "gzip") + "\n", VolumeSamples.gzip(shorts))));
        assertIsSample(read(
                "bzip2.seg.nrrd",
                VolumeSamples.join(VolumeSamples.nrrd("short", "bzip2") + "\n", VolumeSamples.bzip2(shorts))));
        assertIsSample(read(
                "big.nrrd",
                VolumeSamples.join(
                        VolumeSamples.nrrd("int", "raw").replace("endian: little", "endian: big") + "\n",
                        VolumeSamples.voxels(8, BIG, 1))));
        VolumeSamples.write(folder, "voxels.raw", shorts);
        assertIsSample(read(
                "apart.nhdr",
                VolumeSamples.join(
                        VolumeSamples.nrrd("short", "raw"),
                        "data file: voxels.raw\r\n\r\n".getBytes(StandardCharsets.UTF_8))));
    }

    @Test
    void nrrdOfLpsOfOneLayerAndWithSegmentNames() {
        String header = VolumeSamples.nrrd("uchar", "gzip")
                        .replace("right-anterior-superior", "left-posterior-superior")
                        .replace("dimension: 3", "dimension: 4")
                        .replace("sizes: 4 3 2", "sizes: 1 4 3 2")
                        .replace("(-2,0,0) (0,3,0) (0,0,4)", "none (2,0,0) (0,-3,0) (0,0,4)")
                        .replace("domain domain domain", "list domain domain domain")
                        .replace("(10,20,30)", "(-10,-20,30)")
                + "Segment0_LabelValue:=5\nSegment0_Name:=lung: right\n"
                + "Segment1_Name:=liver\nSegment1_LabelValue:=9\n\n";
        LabelVolume volume =
                read("s.seg.nrrd", VolumeSamples.join(header, VolumeSamples.gzip(VolumeSamples.voxels(2, LITTLE, 1))));
        assertIsSample(volume);
        assertThat(volume.names()).containsEntry(5, "lung: right").containsEntry(9, "liver");
    }

    @Test
    void nrrdOfLasIsMirroredFrontToBack() {
        String header = VolumeSamples.nrrd("uchar", "raw")
                .replace("right-anterior-superior", "left-anterior-superior")
                .replace("(-2,0,0) (0,3,0) (0,0,4)", "(2,0,0) (0,3,0) (0,0,4)")
                .replace("(10,20,30)", "(-10,20,30)");
        assertIsSample(read("las.nrrd", VolumeSamples.join(header + "\n", VolumeSamples.voxels(2, LITTLE, 1))));
    }

    /** The first voxel of the sample at (10, 20, 30) mm of RAS, stated in each unit. */
    @Test
    void nrrdInUnitsOfSpaceBecomesMillimetres() {
        byte[] voxels = VolumeSamples.voxels(2, LITTLE, 1);
        String header = VolumeSamples.nrrd("uchar", "raw");
        String[] vectors = {"(-2,0,0) (0,3,0) (0,0,4)", "(10,20,30)"};
        String[] metres = {"(-0.002,0,0) (0,0.003,0) (0,0,0.004)", "(0.01,0.02,0.03)"};
        String[] micrometres = {"(-2000,0,0) (0,3000,0) (0,0,4000)", "(10000,20000,30000)"};
        for (String unit : new String[] {"m", "um", "micron", "mm", "", "furlong"}) {
            String[] stated = unit.equals("m") ? metres : unit.matches("um|micron") ? micrometres : vectors;
            String text = header.replace(vectors[0], stated[0]).replace(vectors[1], stated[1])
                    + "space units: \"U\" \"U\" \"U\"\n\n".replace("U", unit);
            LabelVolume volume = read("units.nrrd", VolumeSamples.join(text, voxels));
            assertIsSample(volume);
            assertThat(volume.notes()).hasSize(unit.equals("furlong") ? 1 : 0);
        }
    }

    /** Spaces of four dimensions have time as the last number of each vector. */
    @Test
    void nrrdWithTimeAmongTheDimensionsOfSpace() {
        byte[] first = VolumeSamples.voxels(2, LITTLE, 1);
        for (String space : new String[] {"right-anterior-superior-time", "RAST"}) {
            String header = VolumeSamples.nrrd("uchar", "raw")
                    .replace("right-anterior-superior", space)
                    .replace("dimension: 3", "dimension: 4")
                    .replace("sizes: 4 3 2", "sizes: 4 3 2 2")
                    .replace("(-2,0,0) (0,3,0) (0,0,4)", "(-2,0,0,0) (0,3,0,0) (0,0,4,0) (0,0,0,0.5)")
                    .replace("kinds: domain domain domain", "kinds: domain domain domain time")
                    .replace("(10,20,30)", "(10,20,30,0)");
            byte[] file = VolumeSamples.join(header + "\n", VolumeSamples.join(new byte[first.length], first));
            Path path = VolumeSamples.write(folder, "breath.nrrd", file);
            assertIsSample(LabelVolumeFiles.read(path.resolveSibling("breath.nrrd#1")));
        }
    }

    /** pynrrd and MetaIO write text; 2 is 2.0, commas and line breaks separate numbers. */
    @Test
    void nrrdAndMetaImageAsText() {
        StringBuilder numbers = new StringBuilder();
        for (int v = 0; v < VolumeSamples.VOXELS; v++) {
            numbers.append(v).append(v % 3 == 0 ? ".0\n" : v % 3 == 1 ? ", " : " ");
        }
        byte[] text = numbers.toString().strip().getBytes(StandardCharsets.US_ASCII);
        String nrrd = VolumeSamples.nrrd("ushort", "ascii").replace("endian: little\n", "");
        assertIsSample(read("text.nrrd", VolumeSamples.join(nrrd + "\n", text)));
        String meta = VolumeSamples.meta("MET_SHORT", false).replace("BinaryData = True", "BinaryData = False");
        assertIsSample(read("text.mha", VolumeSamples.join(meta + "Local\n", text)));
        VolumeSamples.write(folder, "voxels.txt", text);
        assertIsSample(read("text.mhd", (meta + "voxels.txt\n").getBytes(StandardCharsets.UTF_8)));
    }

    @Test
    void nrrdWhoseVoxelsEndTheirFile() {
        byte[] voxels = VolumeSamples.voxels(4, BIG, 1);
        VolumeSamples.write(folder, "scanner.img", VolumeSamples.join(new byte[77], voxels));
        String header = VolumeSamples.nrrd("short", "raw").replace("endian: little", "endian: big")
                + "byte skip: -1\ndata file: scanner.img\n";
        assertIsSample(read("end.nhdr", header.getBytes(StandardCharsets.UTF_8)));
    }

    @Test
    void metaImageLocalPackedApartAndBigEndian() {
        byte[] bytes = VolumeSamples.voxels(2, LITTLE, 1);
        assertIsSample(
                read("local.mha", VolumeSamples.join(VolumeSamples.meta("MET_UCHAR", false) + "LOCAL\n", bytes)));
        assertIsSample(read(
                "packed.mha",
                VolumeSamples.join(VolumeSamples.meta("MET_UCHAR", true) + "LOCAL\n", VolumeSamples.zlib(bytes))));
        byte[] big = VolumeSamples.voxels(16, BIG, 1);
        VolumeSamples.write(folder, "voxels.raw", VolumeSamples.join(new byte[7], big));
        String header = VolumeSamples.meta("MET_FLOAT", false)
                .replace("MSB = False", "MSB = True")
                .replace("DimSize", "HeaderSize = -1\nDimSize");
        assertIsSample(read("apart.mhd", (header + "voxels.raw\n").getBytes(StandardCharsets.UTF_8)));
    }

    @Test
    void labelsAboveABytesTakeTwo() {
        String header = VolumeSamples.nrrd("ushort", "raw");
        LabelVolume volume =
                read("large.nrrd", VolumeSamples.join(header + "\n", VolumeSamples.voxels(512, LITTLE, 2000)));
        for (int v = 0; v < VolumeSamples.VOXELS; v++) {
            assertThat(volume.grid().label(v)).isEqualTo(2000 * v);
        }
        assertThat(volume.grid().counts()).hasSize(2000 * (VolumeSamples.VOXELS - 1) + 1);
    }

    @Test
    void realVolumesOfOtherToolsHaveTheVolumesTheirSourceStates() {
        Path real = Path.of("../shared/segmentations");
        assumeTrue(Files.isDirectory(real), "no ../shared/segmentations here: volumes of other tools are not read");
        LabelVolume lung = LabelVolumeFiles.read(real.resolve("3DCT_lung_baseline_mask.mha"));
        assertThat(lung.grid().counts()[1] * lung.grid().voxelVolume() / 1000).isCloseTo(3364, within(1.0));
        LabelVolume slab = LabelVolumeFiles.read(real.resolve("example_seg.nii.gz"));
        assertThat(slab.names()).containsEntry(5, "liver");
        assertThat(slab.grid().spacing(2)).isCloseTo(3, within(SINGLE_MM));
        LabelVolume pair = LabelVolumeFiles.read(real.resolve("breath-pairs/patient1_expiration.nii.gz"));
        assertThat(pair.grid().counts()[1] * pair.grid().voxelVolume() / 1e6).isCloseTo(3.06, within(0.01));
    }
}
