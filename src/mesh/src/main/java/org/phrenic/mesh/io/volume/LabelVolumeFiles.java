package org.phrenic.mesh.io.volume;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.raster.VolumeFormats;
import org.phrenic.mesh.io.raster.VolumeSource;

/**
 * Reads label volumes: files, whose extension in upper or lower case gives the format, and folders of masks on one
 * grid.
 */
public final class LabelVolumeFiles {
    /** Extensions of the formats that can be read. */
    public static final List<String> READABLE =
            Stream.concat(VolumeFormats.READABLE.stream(), Stream.of("dcm")).toList();

    private LabelVolumeFiles() {}

    /**
     * Whether {@code file} has a volume file extension, in which case it need not exist, is DICOM under a name without
     * any, or is a folder with volumes and without meshes.
     */
    public static boolean isVolume(Path file) {
        if (Files.isDirectory(file)) {
            return LabelFolder.isLabelFolder(file);
        }
        return VolumeFormats.isVolume(VolumeSource.of(file).path()) || DicomVolumes.isDicom(file);
    }

    /**
     * Reads a three-dimensional volume of labels, whole numbers from 0 to 65535 stored in any type. Axes are converted
     * to LPS and spacing to mm. Of a file with several volumes one is chosen by its number, from 0, after the name:
     * {@code scan.nii.gz#2}. The masks of a folder become one volume, with their names.
     *
     * @throws BadInputException if the file cannot be read, has another format, is truncated or damaged, is not
     *     three-dimensional, has a voxel spacing of 0, axes that are not orthogonal, or a value that is not a label
     */
    public static LabelVolume read(Path file) {
        if (Files.isDirectory(file)) {
            return LabelFolder.read(file);
        }
        if (DicomVolumes.isDicom(file)) {
            return DicomVolumes.labels(file);
        }
        return VolumeFormats.read(
                VolumeSource.of(file), stored -> new LabelVolume(stored.labels(), stored.names(), stored.notes()));
    }

    /** Whether a folder is called as data sets and programs call folders of labels, such as labelsTr. */
    public static boolean isCalledLabels(Path folder) {
        return InnerFolders.isCalledLabels(folder);
    }

    /**
     * Refuses a label volume where something else is expected.
     *
     * @param expected such as "a scenario"
     * @throws BadInputException if the path is a volume, or a folder with volumes somewhere within
     */
    public static void refuse(Path file, String expected) {
        if (isVolume(file)) {
            throw new BadInputException(file + ": found a label volume, expected " + expected
                    + "; phrenic import makes a thorax folder of it: phrenic import " + file + " --out patient");
        }
        if (Files.isDirectory(file) && !LabelFolder.isOfMeshes(file)) {
            refuseDeeper(file, expected);
        }
    }

    /** Refuses a folder with volumes in folders farther within, as a data set has them. */
    static void refuseDeeper(Path folder, String expected) {
        InnerFolders.deeper(folder).ifPresent(inner -> {
            throw new BadInputException(folder + ": found volumes in folders farther within, expected " + expected
                    + "; phrenic import takes the folder of one scan: phrenic import " + inner + " --out patient");
        });
    }
}
