package org.phrenic.mesh.io.volume;

import java.nio.file.Path;
import java.util.Map;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.image.VoxelFiles;
import org.phrenic.mesh.io.image.VoxelSeries;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.VoxelBox;

/** Writer of label volumes as NIfTI-1, gzip, unsigned bytes or 16-bit numbers, little-endian, with an sform. */
public final class NiftiWriter {
    private NiftiWriter() {}

    /**
     * Writes a volume to {@code .nii.gz}; the file is written completely or not at all.
     *
     * @throws org.phrenic.file.OutputException if the file cannot be written
     */
    public static void write(Path file, LabelGrid grid) {
        boolean small = grid.counts().length <= LabelGrid.MAX_BYTE_LABEL + 1;
        float[] labels = new float[grid.voxelCount()];
        for (int voxel = 0; voxel < labels.length; voxel++) {
            labels[voxel] = grid.label(voxel);
        }
        ScalarType type = small ? ScalarType.UINT8 : ScalarType.UINT16;
        VoxelFiles.write(file, VoxelSeries.of(VoxelBox.of(grid), 1, type, labels, Map.of()));
    }
}
