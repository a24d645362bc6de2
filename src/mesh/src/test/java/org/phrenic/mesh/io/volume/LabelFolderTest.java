package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.raster.SeveralValuesException;
import org.phrenic.mesh.voxel.LabelGrid;

/** Folders of masks on the grid of {@link VolumeSamples}, which has 24 voxels. */
class LabelFolderTest {
    private static final short UINT8 = 2;
    private static final short INT16 = 4;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeMasks() throws IOException {
        // The lesion lies in the liver, and the body about both.
        mask("body.nii.gz", v -> v < 20);
        mask("liver.nii.gz", v -> v >= 4 && v < 12);
        mask("liver_tumor.nii.gz", v -> v == 5 || v == 6);
        mask("spleen.nii.gz", v -> false);
    }

    private Path mask(String name, IntPredicate within) throws IOException {
        return volume(folder.resolve(name), UINT8, h -> {}, v -> within.test(v) ? 1 : 0);
    }

    private interface Values {
        int at(int voxel);
    }

    private static Path volume(Path path, short type, Consumer<ByteBuffer> change, Values values) throws IOException {
        byte[] file = VolumeSamples.nifti(type, ByteOrder.LITTLE_ENDIAN, change);
        ByteBuffer data = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        for (int v = 0; v < VolumeSamples.VOXELS; v++) {
            if (type == UINT8) {
                data.put(VolumeSamples.NIFTI_HEADER + v, (byte) values.at(v));
            } else {
                data.putShort(VolumeSamples.NIFTI_HEADER + 2 * v, (short) values.at(v));
            }
        }
        Files.createDirectories(path.getParent());
        return Files.write(path, path.toString().endsWith("gz") ? VolumeSamples.gzip(file) : file);
    }

    private static void assertIsMerged(LabelVolume volume) {
        assertThat(volume.names())
                .containsValues("body", "liver", "liver_tumor")
                .hasSize(3);
        LabelGrid grid = volume.grid();
        for (int v = 0; v < grid.voxelCount(); v++) {
            String expected = v == 5 || v == 6 ? "liver_tumor" : v >= 4 && v < 12 ? "liver" : v < 20 ? "body" : null;
            assertThat(volume.names().get(grid.label(v))).as("voxel " + v).isEqualTo(expected);
        }
        double[] place = new double[3];
        grid.voxelToMm(1, 1, 1, place);
        assertThat(place).containsExactly(-8, -23, 34);
    }

    @Test
    void masksBecomeOneVolumeWithTheNamesOfTheirFiles() {
        assertThat(LabelVolumeFiles.isVolume(folder)).isTrue();
        LabelVolume volume = LabelVolumeFiles.read(folder);
        assertIsMerged(volume);
        assertThat(volume.notes()).singleElement().asString().contains("overlap", "10 times");
    }

    @Test
    void imagesAreLeftOutAndAFolderWithinIsFound() throws IOException {
        Path scan = folder.resolve("scan");
        for (String name : new String[] {"body", "liver", "liver_tumor", "spleen"}) {
            Path moved = scan.resolve("segmentations").resolve(name + ".nii.gz");
            Files.createDirectories(moved.getParent());
            Files.move(folder.resolve(name + ".nii.gz"), moved);
        }
        volume(scan.resolve("ct.nii"), INT16, h -> {}, v -> v - 1000);
        assertThat(LabelVolumeFiles.isVolume(scan)).isTrue();
        assertIsMerged(LabelVolumeFiles.read(scan));
        // Beside the masks the image has a note.
        volume(scan.resolve("segmentations").resolve("ct.nii"), INT16, h -> {}, v -> v - 1000);
        assertThat(LabelVolumeFiles.read(scan).notes()).contains("ct.nii is an image and is left out");
    }

    /** A breath of 10 times, displacements and a picture in colours, beside the masks and alone. */
    @Test
    void imagesOfSeveralValuesAreLeftOut() throws IOException {
        Path images = folder.resolve("images");
        volume(
                images.resolve("4dct.nii.gz"),
                INT16,
                h -> h.putShort(40, (short) 4).putShort(48, (short) 10),
                v -> 0);
        volume(
                images.resolve("field.nii"),
                INT16,
                h -> h.putShort(40, (short) 5).putShort(50, (short) 3),
                v -> 0);
        volume(images.resolve("colours.nii"), UINT8, h -> h.putShort(70, (short) 128), v -> 0);
        String channels = VolumeSamples.meta("MET_UCHAR", false)
                .replace("ElementType", "ElementNumberOfChannels = 3\nElementType");
        VolumeSamples.write(images, "colours.mha", VolumeSamples.join(channels + "LOCAL\n", new byte[72]));
        for (String name : new String[] {"4dct.nii.gz", "field.nii", "colours.nii", "colours.mha"}) {
            Path image = folder.resolve(name);
            Files.copy(images.resolve(name), image);
            LabelVolume volume = LabelVolumeFiles.read(folder);
            assertIsMerged(volume);
            assertThat(volume.notes()).contains(name + " has several values a voxel and is left out");
            Files.delete(image);
            assertThatThrownBy(() -> LabelVolumeFiles.read(images.resolve(name)))
                    .as("by itself it is refused for what it is")
                    .isInstanceOf(SeveralValuesException.class)
                    .hasMessageStartingWith(images.resolve(name) + ": ");
        }
        assertThatThrownBy(() -> LabelVolumeFiles.read(images))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("4dct.nii.gz: found 10 volumes, expected the number of one");
    }

    @Test
    void aVolumeAloneKeepsItsLabels() throws IOException {
        Path alone = folder.resolve("alone");
        volume(alone.resolve("ct.nii"), INT16, h -> {}, v -> v - 1000);
        volume(alone.resolve("labels.nii"), UINT8, h -> {}, v -> v);
        LabelVolume volume = LabelVolumeFiles.read(alone);
        assertThat(volume.names()).isEmpty();
        assertThat(volume.grid().label(23)).isEqualTo(23);
    }

    /** A table of labels goes by the numbers in the file: liver and spleen stay 5 and 9. */
    @Test
    void aVolumeAloneKeepsItsLabelsWithTheirNames() throws IOException {
        Path alone = Files.createDirectory(folder.resolve("alone"));
        String header = "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
                + "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: text\n"
                + "Segment0_LabelValue:=5\nSegment0_Name:=liver\nSegment1_LabelValue:=9\nSegment1_Name:=spleen\n\n";
        Path file = alone.resolve("organs.seg.nrrd");
        Files.writeString(file, header + "5 9 0 0 ".repeat(6));
        volume(alone.resolve("ct.nii"), INT16, h -> {}, v -> v - 1000);
        LabelVolume volume = LabelVolumeFiles.read(alone);
        assertThat(volume.names()).isEqualTo(Map.of(5, "liver", 9, "spleen"));
        assertThat(volume.grid().counts())
                .containsExactly(LabelVolumeFiles.read(file).grid().counts());
        assertThat(volume.notes()).containsExactly("ct.nii is an image and is left out");
    }

    @Test
    void aMaskAloneHasTheNameOfItsFile() throws IOException {
        Path alone = folder.resolve("alone");
        volume(alone.resolve("Liver.nii"), UINT8, h -> {}, v -> v > 9 ? 255 : 0);
        LabelVolume volume = LabelVolumeFiles.read(alone);
        assertThat(volume.names()).containsExactly(Map.entry(1, "Liver"));
        assertThat(volume.grid().counts()).containsExactly(10, 14);
    }

    /** Programs number what nobody has named: the file says more, unless the label has a name of its own. */
    @Test
    void aMaskWhoseLabelIsNumberedHasTheNameOfItsFile() throws IOException {
        Path masks = Files.createDirectory(folder.resolve("masks"));
        String header = "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
                + "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: text\n"
                + "Segment0_LabelValue:=1\nSegment0_Name:=";
        Files.writeString(masks.resolve("liver.seg.nrrd"), header + "Segment_1\n\n" + "1 0 0 0 ".repeat(6));
        Files.writeString(masks.resolve("part2.seg.nrrd"), header + "spleen\n\n" + "0 1 0 0 ".repeat(6));
        assertThat(LabelVolumeFiles.read(masks).names().values()).containsExactlyInAnyOrder("liver", "spleen");
    }

    @Test
    void whatCannotBeMergedIsRefusedInOneSentence() throws IOException {
        Path several = volume(folder.resolve("several.nii"), UINT8, h -> {}, v -> v % 3);
        assertRefused("found labels without names beside other volumes");
        Files.delete(several);
        // The first voxel of the sform lies 1 mm, half a voxel, farther.
        Path apart =
                volume(folder.resolve("zz.nii"), UINT8, h -> h.putFloat(280 + 12, h.getFloat(280 + 12) + 1), v -> 1);
        assertRefused("other voxels than those of body.nii.gz");
        Files.write(apart, new byte[] {1, 2, 3});
        assertRefused("zz.nii");
    }

    /**
     * A mask of 2 x 2 x 1 voxels whose first voxel is the second column, row and slice of the others: its voxels lie at
     * their places.
     */
    @Test
    void masksThatAreCroppedArePutTogetherByTheirPlaces() throws IOException {
        byte[] cropped = VolumeSamples.nifti(UINT8, ByteOrder.LITTLE_ENDIAN, h -> {
            h.putShort(42, (short) 2).putShort(44, (short) 2).putShort(46, (short) 1);
            h.putFloat(280 + 12, 10 - 2).putFloat(280 + 28, 20 + 3).putFloat(280 + 44, 30 + 4);
        });
        for (int v = 0; v < 4; v++) {
            cropped[VolumeSamples.NIFTI_HEADER + v] = (byte) (v == 0 ? 0 : 1);
        }
        Files.write(folder.resolve("kidney_left.nii"), cropped);
        LabelVolume volume = LabelVolumeFiles.read(folder);
        LabelGrid grid = volume.grid();
        assertThat(new int[] {grid.columns(), grid.rows(), grid.slices()})
                .containsExactly(VolumeSamples.COLUMNS, VolumeSamples.ROWS, VolumeSamples.SLICES);
        double[] place = new double[3];
        grid.voxelToMm(0, 0, 0, place);
        assertThat(place).as("the first voxel of the others, LPS").containsExactly(-10, -20, 30);
        for (int[] v : new int[][] {{2, 1}, {1, 2}, {2, 2}}) {
            int voxel = v[0] + VolumeSamples.COLUMNS * (v[1] + VolumeSamples.ROWS);
            assertThat(volume.names().get(grid.label(voxel))).isEqualTo("kidney_left");
        }
        assertThat(grid.counts()[indexOf(volume, "kidney_left")]).isEqualTo(3);
        assertThat(volume.notes()).contains("masks of different extents were put together");
        assertThat(volume.withGrid(grid).extent()).isEqualTo(LabelVolume.Extent.LABELS);
    }

    /** A mask of ones that is cropped to a box of voxels of the lattice. */
    private static void box(Path file, int i, int j, int k, int columns, int rows, int slices) throws IOException {
        byte[] nifti = VolumeSamples.nifti(UINT8, ByteOrder.LITTLE_ENDIAN, h -> {
            h.putShort(42, (short) columns).putShort(44, (short) rows).putShort(46, (short) slices);
            h.putFloat(280 + 12, 10 - 2 * i).putFloat(280 + 28, 20 + 3 * j).putFloat(280 + 44, 30 + 4 * k);
        });
        byte[] cropped = Arrays.copyOf(nifti, VolumeSamples.NIFTI_HEADER + columns * rows * slices);
        Arrays.fill(cropped, VolumeSamples.NIFTI_HEADER, cropped.length, (byte) 1);
        Files.write(file, cropped);
    }

    /** The one that is read first neither begins nor ends the box about all. */
    @Test
    void masksReachBeyondTheFirstOnAllSides() throws IOException {
        Path cropped = Files.createDirectory(folder.resolve("cropped"));
        box(cropped.resolve("adrenal_gland_left.nii"), 2, 2, 2, 2, 1, 1);
        box(cropped.resolve("kidney_left.nii"), 0, 1, 1, 1, 2, 2);
        box(cropped.resolve("spleen.nii"), 4, 3, 3, 2, 3, 1);
        LabelVolume volume = LabelVolumeFiles.read(cropped);
        LabelGrid grid = volume.grid();
        List<String> voxels = new ArrayList<>();
        double[] place = new double[3];
        for (int v = 0; v < grid.voxelCount(); v++) {
            int row = v / grid.columns();
            grid.voxelToMm(v % grid.columns(), row % grid.rows(), row / grid.rows(), place);
            if (grid.label(v) > 0) {
                voxels.add(volume.names().get(grid.label(v)).charAt(0) + " " + Math.round((place[0] + 10) / 2)
                        + Math.round((place[1] + 20) / -3) + Math.round((place[2] - 30) / 4));
            }
        }
        assertThat(voxels)
                .containsExactlyInAnyOrder(
                        "a 222", "a 322", "k 011", "k 021", "k 012", "k 022", "s 433", "s 533", "s 443", "s 543",
                        "s 453", "s 553");
    }

    private static int indexOf(LabelVolume volume, String name) {
        return volume.names().entrySet().stream()
                .filter(entry -> entry.getValue().equals(name))
                .findFirst()
                .orElseThrow()
                .getKey();
    }

    private void assertRefused(String message) {
        assertThatThrownBy(() -> LabelVolumeFiles.read(folder))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining(message);
    }

    @Test
    void foldersOfMeshesOrOfNothingAreNoVolumes() throws IOException {
        Files.writeString(folder.resolve("liver.stl"), "solid");
        assertThat(LabelVolumeFiles.isVolume(folder)).isFalse();
        Path images = folder.resolve("images");
        volume(images.resolve("ct.nii"), INT16, h -> {}, v -> v - 1000);
        assertThatThrownBy(() -> LabelVolumeFiles.read(images))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found no label volume");
        assertThat(LabelVolumeFiles.isVolume(Files.createDirectory(folder.resolve("empty"))))
                .isFalse();
    }

    /** Beside each file that macOS copies to another file system it writes one with what it knows of it. */
    @Test
    void hiddenFilesAreNoMasks() throws IOException {
        Files.write(folder.resolve("._liver.nii.gz"), new byte[] {0, 5, 22, 7});
        assertIsMerged(LabelFolder.read(folder));
    }

    @Test
    void aHiddenFolderIsNoFolderOfMasks() throws IOException {
        Path scan = folder.resolve("scan");
        volume(scan.resolve("segmentations").resolve("liver.nii"), UINT8, h -> {}, v -> v < 4 ? 1 : 0);
        volume(scan.resolve(".Trash").resolve("liver.nii"), UINT8, h -> {}, v -> v < 8 ? 1 : 0);
        assertThat(LabelVolumeFiles.read(scan).grid().counts()).containsExactly(20, 4);
    }

    /** Segmentations of two breaths lie on one grid and have the same names. */
    @Test
    void twoFilesOfTheSameStructuresAreRefused() throws IOException {
        Path breaths = Files.createDirectory(folder.resolve("breaths"));
        String header = "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
                + "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: text\n"
                + "Segment0_LabelValue:=1\nSegment0_Name:=liver\nSegment1_LabelValue:=2\nSegment1_Name:=spleen\n\n";
        Files.writeString(breaths.resolve("expiration.seg.nrrd"), header + "1 2 0 0 ".repeat(6));
        Files.writeString(breaths.resolve("inspiration.seg.nrrd"), header + "0 0 1 2 ".repeat(6));
        assertThatThrownBy(() -> LabelVolumeFiles.read(breaths))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining(
                        "found 'liver' and 'spleen' as in expiration.seg.nrrd, expected the labels of one scan");
    }
}
