package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.mesh.voxel.LabelGrid;

/** Slices of DICOM segmentations are as far apart as their planes, whatever is stated beside their positions. */
class SegmentationSpacingTest {
    private static final double MM = 1e-9;
    private static final int SPACING_BETWEEN_SLICES = 0x00180088;
    private static final int SLICE_THICKNESS = 0x00180050;

    @TempDir
    private Path folder;

    /** A liver of four pixels of 2 x 2 mm in each of these planes. */
    private LabelVolume read(byte[] measures, double... heights) {
        return readWithEmpty(0, measures, heights);
    }

    private LabelVolume readWithEmpty(int empty, byte[] measures, double... heights) {
        byte[][] frames = Arrays.stream(heights)
                .mapToObj(height -> DicomSamples.frame(1, height))
                .toArray(byte[][]::new);
        int[] pixels = IntStream.range(0, heights.length * DicomSamples.COLUMNS)
                .map(i -> i < (heights.length - empty) * DicomSamples.COLUMNS ? 1 : 0)
                .toArray();
        byte[] file = DicomSamples.segmentation("BINARY", 1, measures, frames, pixels);
        return LabelVolumeFiles.read(VolumeSamples.write(folder, "planes.dcm", file));
    }

    private static byte[] between(String mm) {
        return DicomSamples.text(SPACING_BETWEEN_SLICES, "DS", mm);
    }

    private static double[] planes(double spacing, int... slices) {
        return Arrays.stream(slices).mapToDouble(slice -> spacing * slice).toArray();
    }

    private static void assertFilled(LabelVolume volume, double spacing, int planes) {
        LabelGrid grid = volume.grid();
        assertThat(grid.spacing(2)).isCloseTo(spacing, within(MM));
        assertThat(grid.counts()[1] * grid.voxelVolume()).isCloseTo(planes * 4 * 4 * spacing, within(1e-6));
    }

    /** Slices of 5 mm with gaps of 0.5 mm between their faces, which is what some programs state. */
    @Test
    void evenPlanesFillTheirDistanceWhereLessIsStated() {
        LabelVolume volume = read(between("0.5"), planes(5.5, 0, 1, 2, 3, 5, 6));
        assertFilled(volume, 5.5, 6);
        assertThat(volume.grid().slices()).isEqualTo(7);
        assertThat(volume.notes())
                .containsExactly("slices are 5.500 mm apart by their positions, and 0.500 mm by what the file states:"
                        + " positions were taken");
        LabelVolume more = read(between("8"), planes(5.5, 0, 1, 2, 4));
        assertFilled(more, 5.5, 4);
        assertThat(more.notes()).singleElement().asString().contains("5.500 mm", "8.000 mm");
    }

    /** 400 slices of 0.703125 mm, stated as 0.7: at the end of them this amounts to 1.8 slices. */
    @Test
    void aRoundedSpacingIsRefinedByPositions() {
        double spacing = 0.703125;
        int[] all = IntStream.range(0, 400).toArray();
        int[] some = IntStream.of(all).filter(k -> k % 5 == 0 || k % 7 == 0).toArray();
        int[] second = IntStream.of(all).filter(k -> k % 2 == 0).toArray();
        for (int[] slices : new int[][] {all, some}) {
            LabelVolume volume = read(between("0.7"), planes(spacing, slices));
            assertFilled(volume, spacing, slices.length);
            assertThat(volume.grid().slices()).isEqualTo(slices[slices.length - 1] + 1);
            assertThat(volume.notes()).isEmpty();
        }
        assertFilled(read(between("0.35"), planes(spacing, all)), spacing / 2, 2 * all.length - 1);
        assertFilled(read(between("0.7"), planes(spacing, second)), spacing, 2 * second.length - 1);
    }

    /** Slice 10 too, as the gap is no wider than two of the usual ones; not 13 to 17. */
    @Test
    void slicesBetweenEverySecondOneAreFilled() {
        LabelVolume second = read(between("2.5"), planes(2.5, 0, 2, 4, 6, 8, 12, 18, 20, 22, 24, 26));
        assertFilled(second, 2.5, 13 + 9);
        assertThat(second.notes())
                .containsExactly("slices between every second one, in which a segment is drawn, have the shape between"
                        + " their neighbours': liver");
        LabelVolume fewer = read(between("2.5"), planes(2.5, 0, 2, 4, 6, 8, 12, 18));
        assertFilled(fewer, 2.5, 7);
        assertThat(fewer.notes()).isEmpty();
    }

    /** A nodule in two or three slices with others between. */
    @Test
    void aSegmentOfAFewSlicesStaysAsItIsDrawn() {
        for (int[] slices : new int[][] {{3, 5}, {3, 5, 7}}) {
            LabelVolume few = read(between("2.5"), planes(2.5, slices));
            assertFilled(few, 2.5, slices.length);
            assertThat(few.notes()).isEmpty();
        }
    }

    /** Segmented in a few slices far apart: a plane is as thick as a slice of the scan. */
    @Test
    void planesOfSlicesBetweenWhichThereAreOthersStayThin() {
        LabelVolume apart = read(between("1"), planes(1, 0, 50));
        assertFilled(apart, 1, 2);
        assertThat(apart.grid().slices()).isEqualTo(51);
        assertFilled(read(between("1"), planes(1, 0, 2, 5, 9, 12)), 1, 5);
    }

    /** A file with an empty frame holds the slices of the scan, one without leaves out those without labels. */
    @Test
    void emptyFramesShowThatNoSliceIsLeftOut() {
        double[] heights = planes(5, 0, 1, 2, 3);
        assertThat(read(between("5"), heights).extent()).isEqualTo(LabelVolume.Extent.LABELLED_SLICES);
        assertThat(readWithEmpty(1, between("5"), heights).extent()).isEqualTo(LabelVolume.Extent.FIELD);
    }

    @Test
    void aSinglePlaneIsAsThickAsStated() {
        byte[] thick = DicomSamples.text(SLICE_THICKNESS, "DS", "5");
        LabelVolume volume = read(thick, 30);
        assertFilled(volume, 5, 1);
        assertThat(volume.notes()).isEmpty();
        assertFilled(read(DicomSamples.joined(thick, between("4")), 30), 4, 1);
        assertFilled(read(thick, planes(3, 0, 1)), 3, 2);
        LabelVolume bare = read(new byte[0], 30);
        assertFilled(bare, 1, 1);
        assertThat(bare.notes()).singleElement().asString().contains("taken to be 1 mm thick");
    }
}
