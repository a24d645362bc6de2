package org.phrenic.mesh.voxel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.io.volume.NiftiWriter;

/** A sphere of 20 mm about (3, -4, 5) in voxels of 1 x 1 x 2 mm. */
class MeshVoxelizerTest {
    private static final int[] SIZE = {50, 50, 25};
    private static final double[] ORIGIN = {-22, -29, -20};
    private static final double[] TO_MM = {1, 0, 0, ORIGIN[0], 0, 1, 0, ORIGIN[1], 0, 0, 2, ORIGIN[2]};
    private static final double[] TO_VOXEL = {1, 0, 0, -ORIGIN[0], 0, 1, 0, -ORIGIN[1], 0, 0, 0.5, -ORIGIN[2] / 2};
    private static final TriangleMesh SPHERE = sphere();

    @TempDir
    Path folder;

    private static TriangleMesh sphere() {
        TriangleMesh unit = Shapes.sphere(20, 4);
        double[] p = unit.positions().clone();
        for (int k = 0; k < p.length; k += 3) {
            p[k] += 3;
            p[k + 1] -= 4;
            p[k + 2] += 5;
        }
        return unit.withPositions(p);
    }

    private static LabelGrid filled() {
        byte[] labels = new byte[SIZE[0] * SIZE[1] * SIZE[2]];
        new MeshVoxelizer(SIZE[0], SIZE[1], SIZE[2], TO_VOXEL, labels).fill(SPHERE, 7);
        return LabelGrid.of(SIZE[0], SIZE[1], SIZE[2], labels, TO_MM);
    }

    @Test
    void insideHasTheVolumeAndThePlaceOfTheMesh() {
        LabelGrid grid = filled();
        double volume = MeshMeasure.signedVolume(SPHERE);
        assertThat(grid.counts()[7] * grid.voxelVolume() / volume).isCloseTo(1, within(0.01));
        double[] at = new double[3];
        for (int v = 0; v < grid.voxelCount(); v++) {
            grid.voxelToMm(v % SIZE[0], v / SIZE[0] % SIZE[1], v / (SIZE[0] * SIZE[1]), at);
            double r = Math.sqrt(Math.pow(at[0] - 3, 2) + Math.pow(at[1] + 4, 2) + Math.pow(at[2] - 5, 2));
            if (Math.abs(r - 20) > 0.5) {
                assertThat(grid.label(v)).as("%s from the middle", r).isEqualTo(r < 20 ? 7 : 0);
            }
        }
    }

    /** As a byte, 256 would be 0, the label of what is outside. */
    @ParameterizedTest
    @ValueSource(ints = {-1, 256})
    void aLabelThatDoesNotFitInAByteIsRefused(int label) {
        MeshVoxelizer voxels = new MeshVoxelizer(1, 1, 1, TO_VOXEL, new byte[1]);
        assertThatThrownBy(() -> voxels.fill(SPHERE, label))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("label: found " + label + ", expected 0 to 255");
    }

    /** What is written is read again: labels, places and spacing, to the single precision of the header. */
    @Test
    void niftiFileHoldsLabelsAndPlaces() {
        LabelGrid grid = filled();
        Path file = folder.resolve("sphere.nii.gz");
        NiftiWriter.write(file, grid);
        LabelVolume read = LabelVolumeFiles.read(file);
        double[] a = new double[3];
        double[] b = new double[3];
        for (int v = 0; v < grid.voxelCount(); v += 97) {
            int i = v % SIZE[0];
            int j = v / SIZE[0] % SIZE[1];
            int k = v / (SIZE[0] * SIZE[1]);
            grid.voxelToMm(i, j, k, a);
            read.grid().voxelToMm(i, j, k, b);
            assertThat(b).containsExactly(a, within(1e-5));
            assertThat(read.grid().label(i, j, k)).isEqualTo(grid.label(i, j, k));
        }
    }
}
