package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.ImageGrid;

/**
 * NIfTI-2, MetaImage, volumes along time and layers of segments that nibabel, SimpleITK and pynrrd wrote
 * ({@code make_fixtures.py}).
 */
class ForeignVolumeTest {
    /** NIfTI-1 places voxels in single precision. */
    private static final double PLACE_MM = 1e-4;

    @ParameterizedTest
    @ValueSource(strings = {"phases_nifti2.nii", "phases.nii.gz", "phases.seq.nrrd", "phases.mha"})
    void everyPhaseHasItsValuesAndPlaces(String name) {
        ImageGrid twin = ImageVolumeFiles.read(VolumeSamples.resource("phases_twin.nii.gz"))
                .grid();
        Path file = VolumeSamples.resource(name);
        for (int phase = 0; phase < 3; phase++) {
            ImageGrid grid = ImageVolumeFiles.read(file.resolveSibling(name + "#" + phase))
                    .grid();
            assertThat(grid.toMm()).containsExactly(twin.toMm(), within(PLACE_MM));
            for (int v = 0; v < twin.values().length; v++) {
                assertThat(grid.values()[v]).isEqualTo(twin.values()[v] + 10 * phase);
            }
        }
        assertThatThrownBy(() -> ImageVolumeFiles.read(file))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("3 volumes, expected the number of one");
    }

    /** Oblique: the directions of the axes are consecutive numbers of the matrix. */
    @Test
    void aMetaImageOfItkHasTheLabelsAndPlacesOfItsTwin() {
        DicomVolumeTest.assertIsTwin(LabelVolumeFiles.read(VolumeSamples.resource("labels.mha")), "labels_twin.nii.gz");
    }

    @Test
    void overlappingLayersOfSegmentsAreMergedAndSingleOnesReadByNumber() {
        LabelVolume volume = LabelVolumeFiles.read(VolumeSamples.resource("overlapping.seg.nrrd"));
        DicomVolumeTest.assertIsTwin(volume, "labels_twin.nii.gz");
        assertThat(volume.names()).isEqualTo(Map.of(1, "liver", 2, "cyst", 3, "spleen"));
        // The plate of 3 x 4 x 3 voxels covers 2 x 4 x 2 of the block.
        assertThat(volume.notes()).singleElement().asString().contains("overlap (16 times");
        Path file = VolumeSamples.resource("overlapping.seg.nrrd");
        LabelVolume layer = LabelVolumeFiles.read(file.resolveSibling("overlapping.seg.nrrd#1"));
        assertThat(layer.names()).isEqualTo(Map.of(1, "cyst", 2, "spleen"));
        assertThat(layer.grid().counts()).containsExactly(336 - 4 - 36, 4, 36);
        assertThatThrownBy(() -> ImageVolumeFiles.read(file))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("in several layers, expected an image");
    }
}
