package org.phrenic.mesh.io.raster;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Map;

/**
 * A volume whose header was read and checked, and whose voxels follow in a stream.
 *
 * @param file name of the file with the voxels, for messages
 * @param in unpacked values of one volume, positioned at the first voxel
 * @param voxels sizes and type of these values
 * @param affine voxel positions, see {@link org.phrenic.mesh.voxel.LabelGrid}
 * @param names names of labels, if the file contains them
 * @param notes assumptions about missing information, one sentence each
 */
public record StoredVolume(
        String file,
        InputStream in,
        VoxelDecoder voxels,
        double[] affine,
        Map<Integer, String> names,
        List<String> notes) {
    /** What is made of the voxels while the file is open. */
    public interface Use<T> {
        T of(StoredVolume volume) throws IOException;
    }
}
