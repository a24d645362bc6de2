package org.phrenic.mesh.io.raster;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.ImageGrid;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * A volume whose header was read and checked, and whose voxels follow in a stream.
 *
 * @param file name of the file with the voxels, for messages
 * @param in unpacked values of one volume, positioned at the first voxel
 * @param voxels sizes and type of these values
 * @param affine voxel positions, see {@link org.phrenic.mesh.voxel.LabelGrid}
 * @param names names of labels, if the file contains them
 * @param notes assumptions about missing information, one sentence each; grows while labels are read
 * @param layers overlapping segments, if the stream has all of their layers
 */
public record StoredVolume(
        String file,
        InputStream in,
        VoxelDecoder voxels,
        double[] affine,
        Map<Integer, String> names,
        List<String> notes,
        Optional<LayeredSegments> layers) {
    /** A volume of one value a voxel. */
    StoredVolume(
            String file,
            InputStream in,
            VoxelDecoder voxels,
            double[] affine,
            Map<Integer, String> names,
            List<String> notes) {
        this(file, in, voxels, affine, names, notes, Optional.empty());
    }

    /** What is made of the voxels while the file is open. */
    public interface Use<T> {
        T of(StoredVolume volume) throws IOException;
    }

    /**
     * Reads the voxels as labels.
     *
     * @throws BadInputException if the data ends too early or a value is no label
     */
    public LabelGrid labels() {
        return layers.isPresent() ? layers.get().merged(this) : voxels.decode(file, in, affine, notes);
    }

    /**
     * Reads the voxels as an image.
     *
     * @throws BadInputException if the data ends too early or a value is not finite
     */
    public ImageGrid image() throws IOException {
        if (layers.isPresent()) {
            throw new BadInputException(file + ": found a segmentation in several layers, expected an image");
        }
        return ImageDecoder.decode(file, in, voxels, affine);
    }
}
