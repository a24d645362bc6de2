package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;

/** Volumes that cannot be used are refused in one sentence that names the file and what was expected. */
class DamagedVolumeTest {
    private static final ByteOrder LITTLE = ByteOrder.LITTLE_ENDIAN;

    @TempDir
    private Path folder;

    private void assertRefused(String part, String name, byte[] content) {
        Path file = VolumeSamples.write(folder, name, content);
        BadInputException refused = catchThrowableOfType(BadInputException.class, () -> LabelVolumeFiles.read(file));
        assertThat(refused).as(name + " is refused").isNotNull();
        assertThat(refused.getMessage())
                .contains(name)
                .contains(part)
                .contains("expected")
                .doesNotContain("\n");
    }

    private void assertNiftiRefused(String part, Consumer<ByteBuffer> change) {
        assertRefused(part, "bad.nii", VolumeSamples.nifti(2, LITTLE, change));
        assertRefused(part, "bad.nii.gz", VolumeSamples.gzip(VolumeSamples.nifti(2, LITTLE, change)));
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @Test
    void dicomWithoutATransferSyntaxIsToBeExportedAgain() {
        byte[] magic = new byte[132];
        System.arraycopy(text("DICM"), 0, magic, 128, 4);
        byte[] other = DicomSamples.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.4");
        assertRefused("export it again", "a.dcm", DicomSamples.joined(magic, other));
    }

    @Test
    void niftiThatIsNone() {
        assertRefused("348 or 540 bytes", "text.nii", text("this is no volume at all"));
        assertNiftiRefused("348 or 540 bytes", h -> h.putInt(0, 77));
        assertNiftiRefused("348 or 540 bytes", h -> h.putInt(0, 540));
        assertNiftiRefused("n+1", h -> h.put(344, (byte) 'x'));
        assertNiftiRefused("pair", h -> h.put(345, (byte) 'i'));
        assertNiftiRefused("datatype 128", h -> h.putShort(70, (short) 128));
        assertNiftiRefused("byte 12", h -> h.putFloat(108, 12));
    }

    @Test
    void dimensionsThatAreNotThree() {
        assertNiftiRefused("2 dimensions", h -> h.putShort(40, (short) 2));
        assertNiftiRefused("5 volumes, expected the number of one, #0 to #4", h -> {
            h.putShort(40, (short) 4);
            h.putShort(48, (short) 5);
        });
        assertNiftiRefused("size of 0", h -> h.putShort(42, (short) 0));
        assertNiftiRefused("2^31", h -> {
            h.putShort(42, Short.MAX_VALUE);
            h.putShort(44, Short.MAX_VALUE);
            h.putShort(46, Short.MAX_VALUE);
        });
        String nrrd = VolumeSamples.nrrd("uchar", "raw");
        byte[] voxels = VolumeSamples.voxels(2, LITTLE, 1);
        assertRefused(
                "2 dimensions",
                "flat.nrrd",
                VolumeSamples.join(
                        nrrd.replace("dimension: 3", "dimension: 2").replace("4 3 2", "12 2") + "\n", voxels));
        assertRefused(
                "2 volumes, expected the number of one",
                "layers.seg.nrrd",
                VolumeSamples.join(
                        nrrd.replace("dimension: 3", "dimension: 4")
                                        .replace("4 3 2", "2 4 3 1")
                                        .replace("(-2", "none (-2")
                                + "\n",
                        voxels));
        assertRefused(
                "as in 'dimension'", "sizes.nrrd", VolumeSamples.join(nrrd.replace("4 3 2", "4 3") + "\n", voxels));
        String meta = VolumeSamples.meta("MET_UCHAR", false);
        assertRefused(
                "2 dimensions",
                "flat.mha",
                VolumeSamples.join(
                        meta.replace("NDims = 3", "NDims = 2").replace("4 3 2", "12 2") + "LOCAL\n", voxels));
        assertRefused(
                "3 values a voxel",
                "rgb.mha",
                VolumeSamples.join("ElementNumberOfChannels = 3\n" + meta + "LOCAL\n", voxels));
    }

    @Test
    void textThatIsNoNumbersOrTooShort() {
        String header = VolumeSamples.nrrd("uchar", "text") + "\n";
        String numbers = "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 ";
        assertRefused("value 23: found 'liver'", "word.nrrd", text(header + numbers + "liver"));
        assertRefused("value 23: found 'nan'", "nan.nrrd", text(header + numbers + "nan"));
        assertRefused("the end after 23 voxels", "short.nrrd", text(header + numbers));
        assertRefused(
                "expected 240000 for 400 x 30 x 20", "none.nrrd", text(header.replace("4 3 2", "400 30 20") + "0"));
        assertRefused("found 23.5", "half.nrrd", text(header + numbers + "23.5"));
    }

    @Test
    void voxelsWithoutSizeAndShearedAxes() {
        assertNiftiRefused("spacing of 0 mm along rows", h -> h.putFloat(300, 0));
        assertNiftiRefused("not finite", h -> h.putFloat(280, Float.NaN));
        assertNiftiRefused("angle of 116.6 deg", h -> h.putFloat(284, 1.5f));
        byte[] voxels = VolumeSamples.voxels(2, LITTLE, 1);
        assertRefused(
                "spacing of 0 mm along slices",
                "zero.mha",
                VolumeSamples.join(
                        VolumeSamples.meta("MET_UCHAR", false).replace("2 3 4", "2 3 0") + "LOCAL\n", voxels));
        assertRefused(
                "right angles",
                "sheared.nrrd",
                VolumeSamples.join(VolumeSamples.nrrd("uchar", "raw").replace("(0,0,4)", "(0,1,4)") + "\n", voxels));
        assertRefused(
                "right angles",
                "sheared.mha",
                VolumeSamples.join(
                        VolumeSamples.meta("MET_UCHAR", false).replace("0 -1 0", "0.3 -1 0") + "LOCAL\n", voxels));
    }

    @Test
    void valuesThatAreNoLabels() {
        byte[] halves = VolumeSamples.join(
                Arrays.copyOf(VolumeSamples.nifti(16, LITTLE, h -> {}), VolumeSamples.NIFTI_HEADER),
                VolumeSamples.voxels(16, LITTLE, 0.5));
        assertRefused("voxel (1, 0, 0): found 0.5", "floats.nii", halves);
        assertRefused(
                "voxel (1, 0, 0): found -1000",
                "hounsfield.nrrd",
                VolumeSamples.join(VolumeSamples.nrrd("short", "raw") + "\n", VolumeSamples.voxels(4, LITTLE, -1000)));
        assertRefused(
                "found 120000",
                "ids.nrrd",
                VolumeSamples.join(VolumeSamples.nrrd("int", "raw") + "\n", VolumeSamples.voxels(8, LITTLE, 120000)));
    }

    @Test
    void filesThatEndTooEarlyOrAreDamaged() {
        byte[] whole = VolumeSamples.nifti();
        assertRefused("19 bytes of voxels", "short.nii", Arrays.copyOf(whole, whole.length - 5));
        byte[] packed = VolumeSamples.gzip(whole);
        assertRefused("expected", "short.nii.gz", Arrays.copyOf(packed, packed.length - 12));
        byte[] checksum = packed.clone();
        checksum[packed.length - 6] ^= 1;
        assertRefused("damaged", "crc.nii.gz", checksum);
        // More data follow than the header states: the checksum is still looked at.
        byte[] longer = VolumeSamples.gzip(Arrays.copyOf(whole, whole.length + 5));
        longer[longer.length - 6] ^= 1;
        assertRefused("damaged", "longer.nii.gz", longer);
        String nrrd = VolumeSamples.nrrd("uchar", "gzip");
        byte[] data = VolumeSamples.gzip(VolumeSamples.voxels(2, LITTLE, 1));
        assertRefused("expected", "short.nrrd", VolumeSamples.join(nrrd + "\n", Arrays.copyOf(data, data.length / 2)));
        assertRefused("damaged", "raw-not-gzip.nrrd", VolumeSamples.join(nrrd + "\n", new byte[40]));
        assertRefused("end of the file", "header.nrrd", text(nrrd));
        assertRefused("not there", "apart.nhdr", text(nrrd + "data file: none.gz\n\n"));
        assertRefused("expected one file", "list.nhdr", text(nrrd + "data file: LIST\na\nb\n"));
        assertRefused("expected one file", "list2.nhdr", text(nrrd + "data file: LIST 2\na\nb\n"));
        assertRefused("expected one file", "numbers.nhdr", text(nrrd + "data file: slice%03d.gz 1 4 1\n\n"));
        assertRefused("'encoding'", "hex.nrrd", text(nrrd.replace("gzip", "hex") + "\n00"));
        String bzip2 = nrrd.replace("gzip", "bzip2") + "\n";
        assertRefused("damaged", "raw-not-bzip2.nrrd", VolumeSamples.join(bzip2, new byte[40]));
        byte[] crc = VolumeSamples.bzip2(VolumeSamples.voxels(2, LITTLE, 1));
        // The block's checksum follows its marker of six bytes, behind the stream's header of four.
        crc[11] ^= 1;
        assertRefused("damaged", "crc.bzip2.nrrd", VolumeSamples.join(bzip2, crc));
        assertRefused("'ElementDataFile'", "header.mha", text("NDims = 3\n"));
        assertRefused(
                "damaged",
                "zlib.mha",
                VolumeSamples.join(VolumeSamples.meta("MET_UCHAR", true) + "LOCAL\n", new byte[30]));
        assertRefused("no 'dimsize'", "keys.mha", text("NDims = 3\nElementDataFile = LOCAL\n"));
    }

    @Test
    void otherFilesAreRefusedByTheirNameOrContent() {
        assertRefused("another ending", "scan.img", new byte[200]);
        for (String packed : List.of("masks.zip", "masks.tar", "masks.tar.gz", "masks.TGZ")) {
            assertRefused("unpack it first", packed, new byte[200]);
        }
        assertRefused("NRRD000", "text.nrrd", text("hello\n\n"));
        assertRefused("key = value", "text.mha", text("hello\n"));
    }

    @Test
    void randomDamageIsEitherReadOrRefusedInOneSentence() {
        Random random = new Random(11);
        byte[][] files = {
            VolumeSamples.nifti(),
            VolumeSamples.gzip(VolumeSamples.nifti(4, ByteOrder.BIG_ENDIAN, h -> {})),
            VolumeSamples.join(VolumeSamples.nrrd("uchar", "raw") + "\n", VolumeSamples.voxels(2, LITTLE, 1)),
            VolumeSamples.join(
                    VolumeSamples.meta("MET_UCHAR", true) + "LOCAL\n",
                    VolumeSamples.zlib(VolumeSamples.voxels(2, LITTLE, 1)))
        };
        String[] names = {"a.nii", "b.nii.gz", "c.nrrd", "d.mha"};
        for (int n = 0; n < 1200; n++) {
            byte[] damaged = files[n % 4].clone();
            for (int k = 1 + random.nextInt(3); k > 0; k--) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
            }
            Path file = VolumeSamples.write(folder, names[n % 4], damaged);
            try {
                assertThat(LabelVolumeFiles.read(file).grid().voxelCount()).isPositive();
            } catch (BadInputException refused) {
                assertThat(refused.getMessage()).contains(names[n % 4]).doesNotContain("\n");
            }
        }
    }
}
