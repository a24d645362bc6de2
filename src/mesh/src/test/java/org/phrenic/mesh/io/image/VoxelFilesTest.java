package org.phrenic.mesh.io.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * Layout of written volumes against numbers set by hand from the formats' definitions: NIfTI-1 (nifti1.h), NRRD 5
 * (teem), MetaIO.
 */
class VoxelFilesTest {
    /** 3 x 2 x 2 voxels of 2 x 3 x 4 mm; rows run to the front, as in many scans. */
    private static final VoxelBox BOX =
            new VoxelBox(new int[] {3, 2, 2}, new double[] {2, 0, 0, 10, 0, 3, 0, -20, 0, 0, 4, 5});

    /** Voxels of 2 x 5 x 10 mm, turned by acos 0.6 about z and then by acos 0.8 about x. */
    private static final VoxelBox OBLIQUE =
            new VoxelBox(new int[] {3, 2, 2}, new double[] {1.2, -4, 0, 10, 1.28, 2.4, -6, -20, 0.96, 1.8, 8, 5});

    @TempDir
    private Path folder;

    /** The vector (v + 0.25, -v, 2 v) at voxel v. */
    private static VoxelSeries field() {
        float[] values = new float[36];
        for (int v = 0; v < 12; v++) {
            values[3 * v] = v + 0.25f;
            values[3 * v + 1] = -v;
            values[3 * v + 2] = 2 * v;
        }
        Map<String, String> about = new LinkedHashMap<>();
        about.put(VoxelSeries.CONTENT, "displacement mm from 0.000 s to 1.250 s");
        about.put("displacement field type", "modeling");
        return VoxelSeries.of(BOX, 3, ScalarType.FLOAT32, values, about);
    }

    private static VoxelSeries series() {
        return new VoxelSeries(
                BOX,
                1,
                ScalarType.INT16,
                VoxelSeries.Times.of(new double[] {1.25, 1.75}),
                frame -> new float[] {-1000, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 + frame, 11},
                Map.of());
    }

    @Test
    void niftiHoldsDisplacementsAsTheFifthDimensionInRas() throws IOException {
        Path file = folder.resolve("field.nii");
        VoxelFiles.write(file, field());
        ByteBuffer b = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        assertThat(b.capacity()).isEqualTo(352 + 4 * 36);
        assertThat(b.getInt(0)).isEqualTo(348);
        short[] dim = new short[6];
        b.position(40).slice().order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(dim);
        assertThat(dim).containsExactly(5, 3, 2, 2, 1, 3);
        assertThat(b.getShort(68)).isEqualTo((short) 1006);
        assertThat(b.getShort(70)).isEqualTo((short) 16);
        assertThat(b.getShort(72)).isEqualTo((short) 32);
        assertThat(b.getFloat(108)).isEqualTo(352);
        assertThat(b.getShort(254)).isEqualTo((short) 1);
        // srow_x = -2 0 0 -10, srow_y = 0 -3 0 20, srow_z = 0 0 4 5
        assertThat(b.getFloat(280)).isEqualTo(-2);
        assertThat(b.getFloat(292)).isEqualTo(-10);
        assertThat(b.getFloat(300)).isEqualTo(-3);
        assertThat(b.getFloat(308)).isEqualTo(20);
        assertThat(b.getFloat(320)).isEqualTo(4);
        assertThat(b.getFloat(324)).isEqualTo(5);
        assertThat(text(b, 148, 39)).isEqualTo("displacement mm from 0.000 s to 1.250 s");
        assertThat(text(b, 328, 12)).isEqualTo("displacement");
        assertThat(text(b, 344, 3)).isEqualTo("n+1");
        // Voxel 7 of each component: x and y turned to the right and the front.
        assertThat(b.getFloat(352 + 4 * 7)).isEqualTo(-7.25f);
        assertThat(b.getFloat(352 + 4 * (12 + 7))).isEqualTo(7);
        assertThat(b.getFloat(352 + 4 * (24 + 7))).isEqualTo(14);
    }

    private static String text(ByteBuffer b, int at, int length) {
        return new String(b.array(), at, length, StandardCharsets.ISO_8859_1);
    }

    @Test
    void niftiHoldsFramesAsTheFourthDimension() throws IOException {
        Path file = folder.resolve("series.nii.gz");
        VoxelFiles.write(file, series());
        ByteBuffer b;
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(Files.readAllBytes(file)))) {
            b = ByteBuffer.wrap(in.readAllBytes()).order(ByteOrder.LITTLE_ENDIAN);
        }
        assertThat(b.capacity()).isEqualTo(352 + 2 * 24);
        assertThat(b.getShort(40)).isEqualTo((short) 4);
        assertThat(b.getShort(48)).isEqualTo((short) 2);
        assertThat(b.getFloat(92)).isEqualTo(0.5f);
        assertThat(b.getFloat(136)).as("time of the first, s").isEqualTo(1.25f);
        assertThat(b.get(123)).as("mm and s").isEqualTo((byte) 10);
        assertThat(b.getShort(352)).isEqualTo((short) -1000);
        assertThat(b.getShort(352 + 2 * (12 + 10))).isEqualTo((short) 11);
    }

    @Test
    void nrrdHoldsVectorsAsTheFastestAxisInLps() throws IOException {
        Path file = folder.resolve("field.nrrd");
        VoxelFiles.write(file, field());
        byte[] bytes = Files.readAllBytes(file);
        String all = new String(bytes, StandardCharsets.ISO_8859_1);
        int end = all.indexOf("\n\n") + 2;
        assertThat(all.substring(0, end).lines())
                .startsWith("NRRD0005")
                .contains(
                        "type: float",
                        "dimension: 4",
                        "space: left-posterior-superior",
                        "sizes: 3 3 2 2",
                        "space directions: none (2.0,0.0,0.0) (0.0,3.0,0.0) (0.0,0.0,4.0)",
                        "kinds: vector domain domain domain",
                        "endian: little",
                        "encoding: gzip",
                        "space origin: (10.0,-20.0,5.0)",
                        "content: displacement mm from 0.000 s to 1.250 s",
                        "displacement field type:=modeling");
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(bytes, end, bytes.length - end))) {
            ByteBuffer b = ByteBuffer.wrap(in.readAllBytes()).order(ByteOrder.LITTLE_ENDIAN);
            assertThat(b.capacity()).isEqualTo(4 * 36);
            assertThat(new float[] {b.getFloat(84), b.getFloat(88), b.getFloat(92)})
                    .containsExactly(7.25f, -7, 14);
        }
    }

    @Test
    void metaImageHoldsThreeChannelsInLps() throws IOException {
        Path file = folder.resolve("field.mha");
        VoxelFiles.write(file, field());
        byte[] bytes = Files.readAllBytes(file);
        int data = bytes.length - 4 * 36;
        assertThat(new String(bytes, 0, data, StandardCharsets.ISO_8859_1).lines())
                .contains(
                        "NDims = 3",
                        "TransformMatrix = 1.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0",
                        "Offset = 10.0 -20.0 5.0",
                        "ElementSpacing = 2.0 3.0 4.0",
                        "DimSize = 3 2 2",
                        "ElementNumberOfChannels = 3",
                        "ElementType = MET_FLOAT")
                .endsWith("ElementDataFile = LOCAL");
        ByteBuffer b = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        assertThat(b.getFloat(data + 12 * 7)).isEqualTo(7.25f);
        assertThat(b.getFloat(data + 12 * 7 + 4)).isEqualTo(-7);
    }

    /** A file of an oblique box in which voxel v has 300 v. */
    private byte[] oblique(String ending) throws IOException {
        float[] values = new float[12];
        for (int v = 0; v < 12; v++) {
            values[v] = 300 * v;
        }
        Path file = folder.resolve("oblique." + ending);
        VoxelFiles.write(file, VoxelSeries.of(OBLIQUE, 1, ScalarType.UINT16, values, Map.of()));
        return Files.readAllBytes(file);
    }

    @Test
    void niftiPlacesAnObliqueBoxAndHoldsLargeLabels() throws IOException {
        ByteBuffer b = ByteBuffer.wrap(oblique("nii")).order(ByteOrder.LITTLE_ENDIAN);
        float[] pixdim = {b.getFloat(80), b.getFloat(84), b.getFloat(88)};
        assertThat(pixdim).containsExactly(new float[] {2, 5, 10}, within(1e-6f));
        float[] rows = new float[12];
        b.position(280).slice().order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().get(rows);
        float[] expected = {-1.2f, 4, 0, -10, -1.28f, -2.4f, 6, 20, 0.96f, 1.8f, 8, 5};
        assertThat(rows).containsExactly(expected, within(1e-6f));
        assertThat(b.getShort(70)).as("unsigned, two bytes").isEqualTo((short) 512);
        assertThat(b.getShort(352 + 2 * 11)).isEqualTo((short) 3300);
    }

    @Test
    void nrrdPlacesAnObliqueBox() throws IOException {
        assertThat(new String(oblique("nrrd"), StandardCharsets.ISO_8859_1).lines())
                .contains(
                        "space directions: (1.2,1.28,0.96) (-4.0,2.4,1.8) (0.0,-6.0,8.0)",
                        "space origin: (10.0,-20.0,5.0)");
    }

    /** Each axis of the voxels is three numbers in turn, of length 1. */
    @Test
    void metaImagePlacesAnObliqueBox() throws IOException {
        String matrix = new String(oblique("mha"), StandardCharsets.ISO_8859_1)
                .lines()
                .filter(line -> line.startsWith("TransformMatrix = "))
                .findFirst()
                .orElseThrow();
        double[] axes = Arrays.stream(matrix.substring(18).split(" "))
                .mapToDouble(Double::parseDouble)
                .toArray();
        double[] expected = {0.6, 0.64, 0.48, -0.8, 0.48, 0.36, 0, -0.6, 0.8};
        assertThat(axes).containsExactly(expected, within(1e-12));
    }

    @Test
    void refusesWhatAFormatHasNoRoomFor() {
        assertThatThrownBy(() -> VoxelFiles.write(folder.resolve("series.mha"), series()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 2 frames, expected nii or nii.gz");
        assertThatThrownBy(() -> VoxelFiles.write(folder.resolve("field.tif"), field()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("expected one of nii.gz");
    }

    /** The recorded output is that of SimpleITK 2.5.7 and nibabel 5.4.2. */
    @Test
    void otherReadersFindTheSameVectorsAtTheSamePlaces() throws IOException, InterruptedException {
        assumeTrue(
                python("-c", "import SimpleITK, nibabel").equals(""),
                "python3 with SimpleITK and nibabel is not there: pip install SimpleITK nibabel");
        for (String ending : VoxelFiles.WRITABLE) {
            VoxelFiles.write(folder.resolve("field." + ending), field());
        }
        VoxelFiles.write(folder.resolve("series.nii.gz"), series());
        Path script = folder.resolve("read_displacement.py");
        Files.write(script, resource("read_displacement.py"));
        assertThat(python(script.toString(), folder.toString()))
                .isEqualTo(new String(resource("read_displacement.txt"), StandardCharsets.UTF_8));
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream in = VoxelFilesTest.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        }
    }

    /** What Python prints, on either stream; "absent" if it is not there. */
    private String python(String... arguments) throws IOException, InterruptedException {
        String[] command = new String[arguments.length + 1];
        command[0] = "python3";
        System.arraycopy(arguments, 0, command, 1, arguments.length);
        Path printed = folder.resolve("printed.txt");
        try {
            Process process = new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(printed.toFile())
                    .start();
            if (!process.waitFor(60, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
        } catch (IOException none) {
            return "absent";
        }
        return Files.readString(printed);
    }
}
