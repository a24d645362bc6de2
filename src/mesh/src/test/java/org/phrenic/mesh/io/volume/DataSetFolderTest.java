package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;

/** Folders as public data sets have them: labels in one folder, images beside it, many scans side by side. */
class DataSetFolderTest {
    private static final short UINT8 = 2;
    private static final short INT16 = 4;

    @TempDir
    private Path folder;

    private Path volume(String name, short type, IntUnaryOperator values) throws IOException {
        byte[] file = VolumeSamples.nifti(type, ByteOrder.LITTLE_ENDIAN, h -> {});
        for (int v = 0; v < VolumeSamples.VOXELS; v++) {
            int value = values.applyAsInt(v);
            int at = VolumeSamples.NIFTI_HEADER + (type == INT16 ? 2 * v : v);
            file[at] = (byte) value;
            if (type == INT16) {
                file[at + 1] = (byte) (value >> Byte.SIZE);
            }
        }
        Path path = folder.resolve(name);
        Files.createDirectories(path.getParent());
        return Files.write(path, name.endsWith("gz") ? VolumeSamples.gzip(file) : file);
    }

    private void masks(String inner) throws IOException {
        volume(inner + "/liver.nii.gz", UINT8, v -> v < 4 ? 1 : 0);
        volume(inner + "/spleen.nii.gz", UINT8, v -> v > 20 ? 1 : 0);
    }

    private LabelVolume assertIsOfMasks(Path scan) {
        assertThat(LabelVolumeFiles.isVolume(scan)).isTrue();
        LabelVolume volume = LabelVolumeFiles.read(scan);
        assertThat(volume.names().values()).containsExactlyInAnyOrder("liver", "spleen");
        return volume;
    }

    @ParameterizedTest
    @ValueSource(strings = {"segmentations", "SEGMENTATIONS", "labels", "masks", "structures_of_reader_2"})
    void theMasksOfACaseAreFoundBesideItsScan(String name) throws IOException {
        volume("s0011/ct.nii.gz", INT16, v -> v - 1000);
        masks("s0011/" + name);
        assertIsOfMasks(folder.resolve("s0011"));
    }

    /** Whether the labels are those of the folder within, or of it in place of a volume beside it. */
    @Test
    void aFileBesideTheFolderOfTheLabelsIsNotLeftOutWithoutAWord() throws IOException {
        Path scan = folder.resolve("scan");
        masks("scan/segmentations");
        byte[] vectors = VolumeSamples.nifti(
                INT16, ByteOrder.LITTLE_ENDIAN, h -> h.putShort(40, (short) 5).putShort(50, (short) 3));
        Files.write(scan.resolve("field.nii"), vectors);
        volume("scan/ct.nii.gz", INT16, v -> v - 1000);
        String[] notes = {
            "ct.nii.gz is an image and is left out", "field.nii has several values a voxel and is left out"
        };
        assertThat(assertIsOfMasks(scan).notes()).containsExactly(notes);
        volume("scan/labels.nii.gz", UINT8, v -> v < 4 ? 5 : v > 20 ? 8 : 0);
        assertThat(assertIsOfMasks(scan).notes())
                .contains(notes)
                .contains("labels.nii.gz is left out, as segmentations holds masks with names");
    }

    /** The mask of a patient without a lesion, beside the masks of all organs. */
    @Test
    void anEmptyMaskBesideTheFolderOfTheMasksTakesNothingFromThem() throws IOException {
        masks("scan/segmentations");
        volume("scan/lesion.nii.gz", UINT8, v -> 0);
        assertIsOfMasks(folder.resolve("scan"));
    }

    /** A volume of numbers says less than masks with names, as in a case of AbdomenAtlas. */
    @Test
    void masksWithNamesArePreferredToOneVolumeOfNumbers() throws IOException {
        volume("BDMAP_00000001/ct.nii.gz", INT16, v -> v - 1000);
        volume("BDMAP_00000001/combined_labels.nii.gz", UINT8, v -> v < 4 ? 5 : v > 20 ? 8 : 0);
        masks("BDMAP_00000001/segmentations");
        assertThat(assertIsOfMasks(folder.resolve("BDMAP_00000001")).notes())
                .contains("combined_labels.nii.gz is left out, as segmentations holds masks with names");
        // A volume alone in there says no more than the one above.
        volume("one/labels.nii.gz", UINT8, v -> v < 4 ? 5 : v > 20 ? 8 : 0);
        volume("one/segmentations/other.nii.gz", UINT8, v -> v < 4 ? 1 : v > 20 ? 2 : 0);
        assertThat(LabelVolumeFiles.read(folder.resolve("one")).grid().label(0)).isEqualTo(5);
    }

    /** A body in numbers keeps its structures where the folder beside it holds masks of other ones, or of a few. */
    @Test
    void aVolumeOfNumbersIsReadWhereNotAllOfItsLabelsAreAmongTheMasks() throws IOException {
        Path scan = folder.resolve("scan");
        volume("scan/totalseg.nii.gz", UINT8, v -> v < 4 ? 5 : v > 20 ? 8 : v == 10 ? 3 : 0);
        masks("scan/masks");
        assertThat(LabelVolumeFiles.read(scan).grid().counts()).containsExactly(16, 0, 0, 1, 0, 4, 0, 0, 3);
        assertThat(LabelVolumeFiles.read(scan).notes())
                .contains("masks is left out, as its masks are not those of all labels of totalseg.nii.gz");
        // The outline of the body holds every label and is none of them.
        volume("scan/masks/body.nii.gz", UINT8, v -> 1);
        volume("scan/masks/cyst.nii.gz", UINT8, v -> v == 12 ? 1 : 0);
        volume("scan/totalseg.nii.gz", UINT8, v -> v < 2 ? 5 : v == 9 ? 8 : v == 10 ? 3 : 0);
        assertThat(LabelVolumeFiles.read(scan).names()).isEmpty();
        volume("scan/masks/gallbladder.nii.gz", UINT8, v -> v == 9 || v == 11 ? 1 : 0);
        volume("scan/masks/duodenum.nii.gz", UINT8, v -> v == 10 ? 1 : 0);
        assertThat(LabelVolumeFiles.read(scan).names().values())
                .as("each label has a mask")
                .contains("liver", "duodenum", "body");
    }

    /** What lies in a folder beside a volume does not keep it from being read. */
    @Test
    void aFolderBesideAVolumeThatCannotBeReadWithItIsLeftOutWithTheReason() throws IOException {
        Path scan = folder.resolve("scan");
        volume("scan/totalseg.nii.gz", UINT8, v -> v < 4 ? 5 : v > 20 ? 8 : 0);
        masks("scan/masks");
        byte[] other = VolumeSamples.nifti(UINT8, ByteOrder.LITTLE_ENDIAN, h -> h.putFloat(280 + 12, 3.5f));
        other[VolumeSamples.NIFTI_HEADER] = 1;
        Path cyst = Files.write(scan.resolve("masks/cyst.nii"), other);
        assertIsReadAlone(scan, "liver.nii.gz: found other voxels than those of cyst.nii");
        Files.write(cyst, new byte[] {1, 2, 3});
        assertIsReadAlone(scan, "cyst.nii");
        volume("scan/masks/cyst.nii", UINT8, v -> v % 3);
        volume("scan/masks/reader.nii", UINT8, v -> v % 4);
        assertIsReadAlone(scan, "found several volumes of labels without names (cyst.nii, reader.nii)");
        Files.delete(cyst);
        assertIsReadAlone(scan, "masks is left out, as totalseg.nii.gz is read, which lies beside it");
    }

    private static void assertIsReadAlone(Path scan, String reason) {
        LabelVolume volume = LabelVolumeFiles.read(scan);
        assertThat(volume.grid().counts()).containsExactly(17, 0, 0, 0, 0, 4, 0, 0, 3);
        assertThat(volume.notes())
                .singleElement()
                .asString()
                .startsWith("masks is left out, as ")
                .contains(reason);
    }

    @Test
    void masksJoinTheOnesBesideTheirFolderUnlessBothHaveTheSameStructure() throws IOException {
        Path scan = folder.resolve("scan");
        volume("scan/ct.nii.gz", INT16, v -> v - 1000);
        volume("scan/body.nii.gz", UINT8, v -> v != 7 ? 1 : 0);
        masks("scan/segmentations");
        LabelVolume volume = LabelVolumeFiles.read(scan);
        assertThat(volume.names().values()).containsExactlyInAnyOrder("body", "liver", "spleen");
        assertThat(volume.names().get(volume.grid().label(0))).isEqualTo("liver");
        assertThat(volume.notes())
                .contains(
                        "the masks of segmentations are taken together with body.nii.gz",
                        "ct.nii.gz is an image and is left out");
        volume("scan/Liver.nii.gz", UINT8, v -> v < 6 ? 1 : 0);
        assertThat(LabelVolumeFiles.read(scan).names().values()).containsExactlyInAnyOrder("body", "Liver");
        assertThat(LabelVolumeFiles.read(scan).notes())
                .contains("segmentations is left out, as it has 'liver' as Liver.nii.gz, body.nii.gz beside it");
    }

    @ParameterizedTest
    @ValueSource(strings = {"images", "imagesTr", "CT", "reader"})
    void foldersOfImagesAreNoFoldersOfMasks(String images) throws IOException {
        masks("scan/organs");
        volume("scan/" + images + "/a.nii.gz", INT16, v -> v - 1000);
        assertIsOfMasks(folder.resolve("scan"));
    }

    @Test
    void aFolderOfMasksMayBeCalledAfterImagesAsAllBesideItAre() throws IOException {
        masks("f/scan");
        volume("f/ct/a.nii.gz", INT16, v -> v - 1000);
        assertIsOfMasks(folder.resolve("f"));
    }

    /** A data set of nnU-Net: labels of several scans in one folder, images in another. */
    @Test
    void aFolderWithTheLabelsOfSeveralScansAsksForOne() throws IOException {
        for (int scan = 1; scan <= 9; scan++) {
            volume("set/labelsTr/case_" + scan + ".nii.gz", UINT8, v -> v % 3);
            volume("set/imagesTr/case_" + scan + "_0000.nii.gz", INT16, v -> v - 1000);
        }
        for (String asked : new String[] {"set", "set/labelsTr"}) {
            assertThatThrownBy(() -> LabelVolumeFiles.read(folder.resolve(asked)))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining(
                            "found several volumes of labels without names (case_1.nii.gz, case_2.nii.gz), expected the"
                                    + " labels of one scan, such as "
                                    + folder.resolve("set/labelsTr/case_1.nii.gz"));
        }
    }

    /** Masks of one structure, each of a scan with its own voxels: the second one tells, and no other is read. */
    @Test
    void masksOfSeveralScansAreRefusedBeforeAllAreRead() throws IOException {
        volume("set/case_1.nii", UINT8, v -> v < 4 ? 1 : 0);
        byte[] other = VolumeSamples.nifti(UINT8, ByteOrder.LITTLE_ENDIAN, h -> h.putFloat(280 + 12, 3.5f));
        other[VolumeSamples.NIFTI_HEADER] = 1;
        Files.write(folder.resolve("set/case_2.nii"), other);
        Files.write(folder.resolve("set/case_3.nii"), new byte[] {1, 2, 3});
        assertThatThrownBy(() -> LabelVolumeFiles.read(folder.resolve("set")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("case_2.nii: found other voxels than those of case_1.nii, expected masks of one"
                        + " scan on one grid");
    }

    @Test
    void theOnlyCaseOfADataSetIsFound() throws IOException {
        volume("set/s0011/ct.nii.gz", INT16, v -> v - 1000);
        masks("set/s0011/segmentations");
        assertIsOfMasks(folder.resolve("set"));
        masks("set/s0012/segmentations");
        volume("set/s0012/ct.nii.gz", INT16, v -> v - 1000);
        assertThatThrownBy(() -> LabelVolumeFiles.read(folder.resolve("set")))
                .hasMessageContaining("found volumes in 2 folders (s0011, s0012), expected the labels of one scan");
    }

    @Test
    void aFolderOfManyCasesAsksForOne() throws IOException {
        for (int scan = 10; scan < 30; scan++) {
            masks("set/s00" + scan + "/segmentations");
            volume("set/s00" + scan + "/ct.nii.gz", INT16, v -> v - 1000);
        }
        assertThat(LabelVolumeFiles.isVolume(folder.resolve("set"))).isTrue();
        assertThatThrownBy(() -> LabelVolumeFiles.read(folder.resolve("set")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining(
                        "found volumes in 20 folders (s0010, s0011, s0012, s0013 ...), expected the labels"
                                + " of one scan, such as " + folder.resolve("set/s0010"));
    }

    /** A tree as of BIDS: derivatives/sub-001/anat. */
    @Test
    void aFolderWithVolumesFartherWithinAsksForTheFolderOfOneScan() throws IOException {
        masks("set/derivatives/sub-001/anat");
        masks("set/derivatives/sub-002/anat");
        Path set = folder.resolve("set");
        assertThat(LabelVolumeFiles.isVolume(set)).isFalse();
        assertThatThrownBy(() -> LabelVolumeFiles.refuse(set, "a folder of meshes"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found volumes in folders farther within, expected a folder of meshes; phrenic"
                        + " import takes the folder of one scan: phrenic import "
                        + set.resolve("derivatives/sub-001/anat"));
        assertThatThrownBy(() -> LabelVolumeFiles.read(set)).hasMessageContaining("farther within");
        LabelVolumeFiles.refuse(Files.createDirectory(folder.resolve("empty")), "a folder of meshes");
    }

    @Test
    void imagesFartherWithinAnImagesFolderAreNotAdvised() throws IOException {
        Path scan = folder.resolve("d");
        volume("d/ct.nii.gz", INT16, v -> v - 1000);
        volume("d/dicom/s1/a.nii.gz", INT16, v -> v - 1000);
        assertThatThrownBy(() -> LabelVolumeFiles.read(scan))
                .isInstanceOf(BadInputException.class)
                .hasMessage(scan + ": found no label volume, expected one: images have to be segmented first");
        masks("d/derivatives/s1");
        assertThatThrownBy(() -> LabelVolumeFiles.read(scan))
                .hasMessageContaining("phrenic import " + scan.resolve("derivatives/s1") + " --out patient");
    }

    /** Links such as "latest" lead back to a folder that holds them, or round through two folders. */
    @Test
    void linksThatLeadBackAreNoFoldersOfLabels() throws IOException {
        volume("c/ct.nii.gz", INT16, v -> v - 1000);
        volume("a/ct.nii.gz", INT16, v -> v - 1000);
        volume("b/ct.nii.gz", INT16, v -> v - 1000);
        Path c = folder.resolve("c");
        try {
            Files.createSymbolicLink(c.resolve("latest"), c);
            Files.createSymbolicLink(folder.resolve("a/other"), folder.resolve("b"));
            Files.createSymbolicLink(folder.resolve("b/other"), folder.resolve("a"));
        } catch (FileSystemException notAllowed) {
            Assumptions.abort("this system lets this user make no links: " + notAllowed.getMessage());
        }
        assertThatThrownBy(() -> LabelVolumeFiles.read(c))
                .isInstanceOf(BadInputException.class)
                .hasMessage(c + ": found no label volume, expected one: images have to be segmented first");
        assertThatThrownBy(() -> LabelVolumeFiles.read(folder.resolve("a")))
                .isInstanceOf(BadInputException.class)
                .hasMessage(folder.resolve("a/other/other/other/other/other")
                        + ": found no label volume, expected one: images have to be segmented first");
        masks("c/organs");
        assertIsOfMasks(c);
    }

    /** Grey values of MR are whole numbers from 0 on, and so are labels: they change from voxel to voxel. */
    @Test
    void greyValuesWithoutNegativeOnesAreNoLabels() throws IOException {
        masks("scan");
        byte[] image = VolumeSamples.nifti(UINT8, ByteOrder.LITTLE_ENDIAN, h -> h.putShort(46, (short) 8));
        byte[] tall = VolumeSamples.join(
                Arrays.copyOf(image, VolumeSamples.NIFTI_HEADER),
                new byte[VolumeSamples.COLUMNS * VolumeSamples.ROWS * 8]);
        for (int v = VolumeSamples.NIFTI_HEADER; v < tall.length; v++) {
            tall[v] = (byte) (v * 7);
        }
        Files.write(folder.resolve("scan").resolve("mri.nii"), tall);
        assertThat(assertIsOfMasks(folder.resolve("scan")).notes()).contains("mri.nii is an image and is left out");
        assertThat(LabelVolumeFiles.read(folder.resolve("scan").resolve("mri.nii"))
                        .isImage())
                .isTrue();
    }
}
