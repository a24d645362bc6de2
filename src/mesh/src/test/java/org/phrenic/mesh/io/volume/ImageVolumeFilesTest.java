package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.ImageGrid;

/** Images come out with their values and places from every format; of several volumes one is chosen by its number. */
class ImageVolumeFilesTest {
    private static final double SINGLE_MM = 1e-5;
    private static final ByteOrder LITTLE = ByteOrder.LITTLE_ENDIAN;

    @TempDir
    private Path folder;

    private ImageGrid read(String name, byte[] content) {
        return ImageVolumeFiles.read(VolumeSamples.write(folder, name, content)).grid();
    }

    /** The sample's voxel v has the value slope v + intercept, at the places of {@link VolumeSamples#nifti}. */
    private static void assertIsSample(ImageGrid grid, double slope, double intercept) {
        assertThat(new int[] {grid.columns(), grid.rows(), grid.slices()}).containsExactly(4, 3, 2);
        for (int v = 0; v < VolumeSamples.VOXELS; v++) {
            assertThat(grid.values()[v]).isEqualTo((float) (slope * v + intercept));
        }
        assertThat(grid.value(3, 2, 1)).isEqualTo(grid.values()[23]);
        double[] place = new double[3];
        grid.voxelToMm(1, 1, 1, place);
        assertThat(place).containsExactly(new double[] {-8, -23, 34}, within(SINGLE_MM));
        assertThat(grid.toMm())
                .containsExactly(new double[] {2, 0, 0, -10, 0, -3, 0, -20, 0, 0, 4, 30}, within(SINGLE_MM));
    }

    /** Two volumes of the sample one after the other: the labels, and ten times the labels. */
    private static byte[] twoPhases() {
        byte[] first = VolumeSamples.nifti(4, LITTLE, h -> {
            h.putShort(40, (short) 4);
            h.putShort(48, (short) 2);
        });
        return VolumeSamples.join(first, VolumeSamples.voxels(4, LITTLE, 10));
    }

    @Test
    void valuesOfEveryFormatAreThoseStored() {
        byte[] hounsfield = VolumeSamples.voxels(4, LITTLE, -40);
        assertIsSample(
                read("ct.nrrd", VolumeSamples.join(VolumeSamples.nrrd("short", "raw") + "\n", hounsfield)), -40, 0);
        String meta = VolumeSamples.meta("MET_SHORT", true) + "LOCAL\n";
        assertIsSample(read("ct.mha", VolumeSamples.join(meta, VolumeSamples.zlib(hounsfield))), -40, 0);
        assertIsSample(read("gzip.mha", VolumeSamples.join(meta, VolumeSamples.gzip(hounsfield))), -40, 0);
        byte[] scaled = VolumeSamples.nifti(64, ByteOrder.BIG_ENDIAN, h -> {
            h.putFloat(112, 0.5f);
            h.putFloat(116, -1024);
        });
        assertIsSample(read("ct.nii.gz", VolumeSamples.gzip(scaled)), 0.5, -1024);
    }

    @Test
    void onePhaseOfSeveralIsChosenByItsNumber() {
        byte[] phases = twoPhases();
        VolumeSamples.write(folder, "breath.nii", phases);
        VolumeSamples.write(folder, "breath.nii.gz", VolumeSamples.gzip(phases));
        for (String name : new String[] {"breath.nii", "breath.nii.gz"}) {
            assertIsSample(ImageVolumeFiles.read(folder.resolve(name + "#0")).grid(), 1, 0);
            assertIsSample(ImageVolumeFiles.read(folder.resolve(name + "#1")).grid(), 10, 0);
            assertThat(LabelVolumeFiles.isVolume(folder.resolve(name + "#1"))).isTrue();
            assertThat(LabelVolumeFiles.read(folder.resolve(name + "#1")).grid().label(23))
                    .isEqualTo(230);
        }
        assertThatThrownBy(() -> ImageVolumeFiles.read(folder.resolve("breath.nii")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("2 volumes, expected the number of one, #0 to #1")
                .hasMessageContaining("breath.nii#0");
        assertThatThrownBy(() -> ImageVolumeFiles.read(folder.resolve("breath.nii#2")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("none with the number 2, expected a number from 0 to 1");
    }

    /** 3D Slicer stores a sequence with the list of volumes as the first axis or the last. */
    @Test
    void sequencesListTheirVolumesFirstOrLast() {
        byte[] one = VolumeSamples.voxels(4, LITTLE, 1);
        byte[] ten = VolumeSamples.voxels(4, LITTLE, 10);
        ByteBuffer sideBySide = ByteBuffer.allocate(2 * one.length);
        for (int v = 0; v < one.length; v += 2) {
            sideBySide.put(one, v, 2).put(ten, v, 2);
        }
        String header = VolumeSamples.nrrd("short", "gzip").replace("dimension: 3", "dimension: 4") + "\n";
        String first = header.replace("4 3 2", "2 4 3 2")
                .replace("(-2,0,0)", "none (-2,0,0)")
                .replace("kinds: domain", "kinds: list domain domain");
        VolumeSamples.write(
                folder, "first.seq.nrrd", VolumeSamples.join(first, VolumeSamples.gzip(sideBySide.array())));
        String last = header.replace("4 3 2", "4 3 2 2")
                .replace("(0,0,4)", "(0,0,4) none")
                .replace("kinds: domain domain domain", "kinds: domain domain domain list");
        VolumeSamples.write(
                folder, "last.seq.nrrd", VolumeSamples.join(last, VolumeSamples.gzip(VolumeSamples.join(one, ten))));
        for (String name : new String[] {"first.seq.nrrd", "last.seq.nrrd"}) {
            assertIsSample(ImageVolumeFiles.read(folder.resolve(name + "#0")).grid(), 1, 0);
            assertIsSample(ImageVolumeFiles.read(folder.resolve(name + "#1")).grid(), 10, 0);
        }
    }

    @Test
    void valuesThatAreNotFiniteAndFilesThatEndEarlyAreRefused() {
        byte[] file = VolumeSamples.nifti(16, LITTLE, h -> {});
        ByteBuffer.wrap(file).order(LITTLE).putFloat(VolumeSamples.NIFTI_HEADER + 4 * 17, Float.NaN);
        assertThatThrownBy(() -> read("nan.nii", file))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("voxel (1, 1, 1): found NaN, expected a finite number");
        byte[] packed = VolumeSamples.gzip(VolumeSamples.nifti(16, LITTLE, h -> h.putShort(46, (short) 3)));
        assertThatThrownBy(() -> read("short.nii.gz", packed))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("ends too early");
    }
}
