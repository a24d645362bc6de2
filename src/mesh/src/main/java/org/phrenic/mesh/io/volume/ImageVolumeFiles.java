package org.phrenic.mesh.io.volume;

import java.nio.file.Files;
import java.nio.file.Path;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.raster.VolumeFormats;
import org.phrenic.mesh.io.raster.VolumeSource;

/**
 * Reads image volumes: one real value a voxel. The formats are those of {@link LabelVolumeFiles}; a folder is a series
 * of DICOM slices.
 */
public final class ImageVolumeFiles {
    private ImageVolumeFiles() {}

    /**
     * Reads a three-dimensional image of any number type; the scaling that a file states is applied. Axes are converted
     * to LPS and spacing to mm. One phase of several is chosen as in {@link VolumeSource}.
     *
     * @throws BadInputException if the file cannot be read, has another format, is truncated or damaged, is not
     *     three-dimensional, has a voxel spacing of 0, axes that are not orthogonal, or a value that is not finite
     */
    public static ImageVolume read(Path file) {
        if (Files.isDirectory(file)) {
            return DicomSeries.readFolder(file);
        }
        if (DicomVolumes.isDicom(file)) {
            return DicomVolumes.image(file);
        }
        return VolumeFormats.read(VolumeSource.of(file), stored -> new ImageVolume(stored.image(), stored.notes()));
    }
}
