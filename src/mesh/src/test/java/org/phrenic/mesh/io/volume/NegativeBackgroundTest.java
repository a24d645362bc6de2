package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

/** Label volumes whose background is a negative number, and labels with the noise of a resampling. */
class NegativeBackgroundTest {
    private static final int LIVER = 6;
    private static final int[] CORNERS = {0, 3, 8, 11, 12, 15, 20, 23};

    @TempDir
    private Path folder;

    private LabelVolume read(double... values) {
        String text = Arrays.stream(values).mapToObj(Double::toString).collect(Collectors.joining(" "));
        String header = VolumeSamples.nrrd("double", "ascii").replace("endian: little\n", "");
        return LabelVolumeFiles.read(VolumeSamples.write(
                folder, "labels.nrrd", VolumeSamples.join(header + "\n", text.getBytes(StandardCharsets.US_ASCII))));
    }

    /** A volume of one value but for two voxels in its middle. */
    private static double[] volume(double background, double first, double second) {
        double[] values = new double[VolumeSamples.VOXELS];
        Arrays.fill(values, background);
        values[LIVER] = first;
        values[LIVER - 1] = second;
        return values;
    }

    private void assertRefused(String found, double... values) {
        assertThatThrownBy(() -> read(values))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found " + found + ", expected a label");
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, -1000, -32768})
    void oneNegativeValueOfMostVoxelsAndTheCornersIsBackground(double background) {
        for (double label : new double[] {5, 300}) {
            LabelVolume volume = read(volume(background, label, label));
            LabelGrid grid = volume.grid();
            assertThat(grid.label(LIVER)).isEqualTo((int) label);
            assertThat(grid.counts()[0]).isEqualTo(VolumeSamples.VOXELS - 2);
            assertThat(volume.notes())
                    .containsExactly("the value " + (int) background
                            + " is background, as the most frequent one and that of the corners");
        }
        assertThat(read(volume(0, 5, 0)).notes()).isEmpty();
    }

    /** Labels that are counted from 0 have -1 for none: their 0 is the first structure. */
    @Test
    void zerosBesideMinusOneAreNotTakenForBackground() {
        assertThatThrownBy(() -> read(volume(-1, 5, 0)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found " + (VolumeSamples.VOXELS - 2) + " voxels of -1 and 1 of 0, expected one");
    }

    /** A value beyond a round field of view, and 0 within it. */
    @ParameterizedTest
    @ValueSource(doubles = {-1, -1000})
    void zerosThatAreMoreFrequentAreBackgroundToo(double beyond) {
        for (double label : new double[] {5, 300}) {
            double[] values = volume(0, label, label);
            for (int corner : CORNERS) {
                values[corner] = beyond;
            }
            LabelVolume volume = read(values);
            assertThat(volume.grid().counts()[0]).isEqualTo(VolumeSamples.VOXELS - 2);
            assertThat(volume.notes())
                    .containsExactly("the values " + (int) beyond
                            + " and 0 are background, as the most frequent ones and those of the corners");
        }
        assertThat(read(volume(-1000, 5, 0)).notes())
                .hasSize(1)
                .first()
                .asString()
                .contains("-1000 and 0 are");
    }

    @Test
    void anotherNegativeValueIsNone() {
        assertRefused("-2", volume(-1, 5, -2));
        assertRefused("-1", volume(0, 5, -1));
        assertRefused("-1.5", volume(-1.5, 5, 6));
        assertRefused("-1.0E300", volume(-1e300, 5, 6));
    }

    @Test
    void aNegativeValueThatOtherCornersOrMoreVoxelsLackIsNone() {
        for (int corner : new int[] {3, 8, 11, 12, 15, 20, 23}) {
            double[] values = volume(-1, 5, 5);
            values[corner] = 5;
            assertRefused("-1", values);
        }
        double[] rare = volume(5, 5, 5);
        for (int corner : CORNERS) {
            rare[corner] = -1;
        }
        assertRefused("-1", rare);
    }

    @Test
    void aValueNearAWholeNumberIsThatLabel() {
        LabelGrid grid = read(volume(-0.0001, 5.0001, 4.995)).grid();
        assertThat(grid.label(LIVER)).isEqualTo(5);
        assertThat(grid.label(LIVER - 1)).isEqualTo(5);
        assertThat(grid.label(0)).isZero();
        assertThat(read(volume(-999.9999, 5, 5)).grid().label(0)).isZero();
        assertRefused("5.02", volume(0, 5.02, 5));
        assertRefused("4.98", volume(0, 5, 4.98));
    }
}
