package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The number of a region of a structure set only identifies it (PS3.3, C.8.8.5): any whole number does. */
class RegionNumberTest {
    private static final int[] SIDES = {4, 6, 8, 10};
    private static final String[] NAMES = {"cyst", "spleen", "liver", "body"};

    @TempDir
    private Path folder;

    private static byte[] region(String number, String name) {
        return DicomSamples.joined(
                DicomSamples.text(0x30060022, "IS", number), DicomSamples.text(0x30060026, "LO", name));
    }

    /** A square in two planes 3 mm apart, beside those of other regions. */
    private static byte[] contours(String number, int left, int side) {
        byte[][] squares = new byte[2][];
        for (int k = 0; k < squares.length; k++) {
            int right = left + side;
            String corners = "%d\\0\\%d\\%d\\0\\%d\\%d\\%d\\%d\\%d\\%d\\%d"
                    .formatted(left, 3 * k, right, 3 * k, right, side, 3 * k, left, side, 3 * k);
            squares[k] = DicomSamples.joined(
                    DicomSamples.text(0x30060042, "CS", "CLOSED_PLANAR"), DicomSamples.text(0x30060050, "DS", corners));
        }
        return DicomSamples.joined(
                DicomSamples.sequence(0x30060040, squares), DicomSamples.text(0x30060084, "IS", number));
    }

    private LabelVolume read(String... numbers) {
        byte[][] contours = new byte[numbers.length][];
        Arrays.setAll(contours, n -> contours(numbers[n], 20 * n, SIDES[n]));
        return read(numbers, contours);
    }

    private LabelVolume read(String[] numbers, byte[][] contours) {
        byte[][] regions = new byte[numbers.length][];
        Arrays.setAll(regions, n -> region(numbers[n], NAMES[n]));
        byte[] file = DicomSamples.file(
                "1.2.840.10008.5.1.4.1.1.481.3",
                DicomSamples.sequence(0x30060020, regions),
                DicomSamples.sequence(0x30060039, contours));
        return LabelVolumeFiles.read(VolumeSamples.write(folder, "regions.dcm", file));
    }

    /** Labels 1 and 3 are taken: 0 and 70000 become 2 and 4, with their names and their own contours. */
    @Test
    void numbersThatAreNoLabelsBecomeFreeOnes() {
        LabelVolume volume = read("70000", "3", "0", "1");
        assertThat(volume.names()).isEqualTo(Map.of(1, "body", 2, "liver", 3, "spleen", 4, "cyst"));
        assertThat(volume.grid().counts()).endsWith(2 * 10 * 10, 2 * 8 * 8, 2 * 6 * 6, 2 * 4 * 4);
        assertThat(volume.notes())
                .contains("region numbers that are no labels from 1 to 65535 were changed: liver from 0 to 2, cyst from"
                        + " 70000 to 4");
    }

    /** As editors leave them of a region that was emptied, and a point of interest. */
    @Test
    void contoursWithoutPointsOrTypeAreLeftOutWithANote() {
        byte[] closed = DicomSamples.text(0x30060042, "CS", "CLOSED_PLANAR");
        byte[] place = DicomSamples.text(0x30060050, "DS", "1\\2\\3");
        byte[] point = DicomSamples.joined(DicomSamples.text(0x30060042, "CS", "POINT"), place);
        byte[] emptied = DicomSamples.joined(
                DicomSamples.sequence(0x30060040, closed, place, point), DicomSamples.text(0x30060084, "IS", "2"));
        LabelVolume volume = read(new String[] {"1", "2"}, new byte[][] {contours("1", 0, 10), emptied});
        assertThat(volume.names()).isEqualTo(Map.of(1, "cyst"));
        assertThat(volume.notes()).contains("3 points, open and empty contours are no volumes and were left out");
    }

    @Test
    void numbersThatAreLabelsStay() {
        LabelVolume volume = read("65535", "3", "12", "1");
        assertThat(volume.names()).isEqualTo(Map.of(1, "body", 12, "liver", 3, "spleen", 65535, "cyst"));
        assertThat(volume.notes()).noneMatch(note -> note.contains("numbers"));
    }
}
