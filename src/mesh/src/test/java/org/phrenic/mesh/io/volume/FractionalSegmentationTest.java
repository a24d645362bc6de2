package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

/** Fractional segmentations of DICOM (PS3.3, C.8.20.2). */
class FractionalSegmentationTest {
    @TempDir
    private Path folder;

    /** Four columns, one row, two slices 3 mm apart; a liver in both, a cyst in the upper one. */
    private Path file(String type, int maximum, int... fractions) {
        byte[][] frames = {DicomSamples.frame(1, 0), DicomSamples.frame(1, 3), DicomSamples.frame(2, 3)};
        byte[] content = DicomSamples.segmentation(type, maximum, new byte[0], frames, fractions);
        return VolumeSamples.write(folder, "fractions.dcm", content);
    }

    @Test
    void aVoxelIsInASegmentFromAHalfOn() {
        int[] fractions = {0, 127, 128, 255, 255, 255, 255, 0, 0, 255, 100, 0};
        LabelVolume volume = LabelVolumeFiles.read(file("FRACTIONAL", 255, fractions));
        LabelGrid grid = volume.grid();
        assertThat(IntStream.range(0, grid.voxelCount()).map(grid::label)).containsExactly(0, 0, 1, 1, 1, 2, 1, 0);
        assertThat(volume.names()).isEqualTo(Map.of(1, "liver", 2, "cyst"));
        assertThat(volume.notes()).anyMatch(note -> note.contains("a half or more"));
        double[] place = new double[3];
        grid.voxelToMm(3, 0, 1, place);
        assertThat(place).containsExactly(new double[] {16, 20, 3}, within(1e-12));
    }

    @Test
    void anEvenMaximumHasItsHalfInTheSegment() {
        LabelGrid grid = LabelVolumeFiles.read(file("FRACTIONAL", 100, 49, 50, 51, 100, 0, 0, 0, 0, 0, 0, 0, 0))
                .grid();
        assertThat(IntStream.range(0, DicomSamples.COLUMNS).map(grid::label)).containsExactly(0, 1, 1, 1);
    }

    /** "Kidney" twice, and the side in the modifier of the coded type alone. */
    @ParameterizedTest
    @CsvSource({
        "Kidney, Right, Right Kidney",
        "Kidney, left, left Kidney",
        "kidney_left, Left, kidney_left",
        "Niere links, Left, Niere links",
        "Kidney_L, Left, Kidney_L",
        "Kidney, Right and left, Kidney",
        "Kidney, Upper, Kidney",
    })
    void aSideThatTheTypeStatesAloneIsPartOfTheName(String label, String modifier, String name) {
        byte[] segments = DicomSamples.sequence(0x00620002, DicomSamples.segment(1, label, modifier));
        byte[][] frames = {DicomSamples.frame(1, 0)};
        Path file = VolumeSamples.write(
                folder,
                "sides.dcm",
                DicomSamples.segmentation(segments, "FRACTIONAL", 2, new byte[0], frames, 0, 2, 2, 0));
        assertThat(LabelVolumeFiles.read(file).names()).isEqualTo(Map.of(1, name));
    }

    /** Frames of four bits: each second one begins within a byte (PS3.5, 8.1.1). */
    @Test
    void bitsOfAFrameFollowThoseOfTheLastWithoutPadding() {
        byte[][] frames = {DicomSamples.frame(1, 0), DicomSamples.frame(1, 3), DicomSamples.frame(2, 6)};
        byte[] file = DicomSamples.bits(frames, 1, 0, 0, 1, 0, 1, 1, 1, 0, 0, 1, 0);
        LabelGrid grid = LabelVolumeFiles.read(VolumeSamples.write(folder, "bits.dcm", file))
                .grid();
        assertThat(IntStream.range(0, 12).map(grid::label)).containsExactly(1, 0, 0, 1, 0, 1, 1, 1, 0, 0, 2, 0);
    }

    @Test
    void anotherTypeIsRefused() {
        assertThatThrownBy(() -> LabelVolumeFiles.read(file("VECTOR", 255, new int[12])))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 'VECTOR', expected BINARY, FRACTIONAL or LABELMAP");
    }
}
