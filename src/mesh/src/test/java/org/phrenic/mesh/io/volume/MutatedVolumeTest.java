package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;

/**
 * Files of other programs with bytes changed, cut off, doubled or set to extremes are read or refused in one sentence.
 * The system property {@code phrenic.mutations} is the number of files; a fixed seed gives the same ones every time.
 */
class MutatedVolumeTest {
    private static final int MUTATIONS = Integer.getInteger("phrenic.mutations", 1500);
    private static final List<String> LABELS = List.of(
            "overlapping_seg.dcm",
            "turned_seg.dcm",
            "implicit_seg.dcm",
            "deflated_seg.dcm",
            "map_seg.dcm",
            "map_rle_seg.dcm",
            "contours_alone.dcm",
            "ct/contours.dcm",
            "regions_twin.nii.gz",
            "overlapping.seg.nrrd",
            "phases_nifti2.nii",
            "phases.seq.nrrd");

    @TempDir
    private Path folder;

    /** Headers come first in most files, and numbers of all bits or of the sign bit alone are the worst. */
    private static byte[] mutated(byte[] content, Random random) {
        byte[] changed = content.clone();
        for (int n = 1 + random.nextInt(4); n > 0; n--) {
            int within = random.nextBoolean() ? changed.length : Math.min(changed.length, 400);
            int at = random.nextInt(within);
            switch (random.nextInt(5)) {
                case 0 -> changed[at] ^= (byte) (1 << random.nextInt(8));
                case 1 -> changed[at] = (byte) random.nextInt(256);
                case 2 -> Arrays.fill(changed, at, Math.min(changed.length, at + 4), (byte) 0xFF);
                case 3 -> changed = Arrays.copyOf(changed, Math.max(1, at));
                default -> {
                    int from = random.nextInt(changed.length);
                    int length = Math.min(random.nextInt(40), changed.length - Math.max(from, at));
                    System.arraycopy(changed, from, changed, at, length);
                }
            }
        }
        return changed;
    }

    /** @return whether the volume was read */
    private static boolean isRead(Path file, boolean isImage) {
        try {
            int voxels = isImage
                    ? ImageVolumeFiles.read(file).grid().values().length
                    : LabelVolumeFiles.read(file).grid().voxelCount();
            assertThat(voxels).isPositive();
            return true;
        } catch (BadInputException refused) {
            assertThat(refused.getMessage()).doesNotContain("\n").hasSizeBetween(20, 600);
            return false;
        }
    }

    @Test
    void volumesAreReadOrRefusedInOneSentence() throws IOException {
        Path series = Files.createDirectory(folder.resolve("series"));
        for (int k = 0; k < 6; k++) {
            Files.copy(VolumeSamples.resource("ct/IM" + k + ".dcm"), series.resolve("IM" + k + ".dcm"));
        }
        Random random = new Random(17);
        byte[][] contents = new byte[LABELS.size()][];
        for (int n = 0; n < contents.length; n++) {
            contents[n] = Files.readAllBytes(VolumeSamples.resource(LABELS.get(n)));
        }
        int read = 0;
        for (int n = 0; n < MUTATIONS; n++) {
            int which = n % contents.length;
            String name = LABELS.get(which);
            Path place = name.startsWith("ct/") ? series : folder;
            Path file = place.resolve(name.substring(name.indexOf('/') + 1));
            Files.write(file, mutated(contents[which], random));
            boolean isImage = name.startsWith("phases");
            read += isRead(isImage ? file.resolveSibling(file.getFileName() + "#1") : file, isImage) ? 1 : 0;
            Files.delete(file);
        }
        assertThat(read).isBetween(MUTATIONS / 20, MUTATIONS * 19 / 20);
    }

    @Test
    void slicesOfASeriesAreReadOrRefusedInOneSentence() throws IOException {
        Path series = Files.createDirectory(folder.resolve("series"));
        Files.copy(VolumeSamples.resource("ct/IM0.dcm"), series.resolve("IM0.dcm"));
        byte[] slice = Files.readAllBytes(VolumeSamples.resource("ct/IM1.dcm"));
        Random random = new Random(18);
        int read = 0;
        for (int n = 0; n < MUTATIONS / 5; n++) {
            Files.write(series.resolve("IM1.dcm"), mutated(slice, random));
            read += isRead(series, true) ? 1 : 0;
        }
        assertThat(read).isBetween(MUTATIONS / 100, MUTATIONS / 5 - 10);
    }
}
