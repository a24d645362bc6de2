package org.phrenic.mesh.io.volume;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;

/** Volumes of labels in files: the format is told by the extension, in upper or lower case. */
public final class LabelVolumeFiles {
    /** Endings of names that can be read. */
    public static final List<String> READABLE = List.of("nii", "nii.gz", "nrrd", "nhdr", "mha", "mhd");

    private LabelVolumeFiles() {}

    /** Whether the name of {@code file} says that it is a volume; the file need not exist. */
    public static boolean isVolume(Path file) {
        String name = name(file);
        return READABLE.stream().anyMatch(ending -> name.endsWith("." + ending));
    }

    /**
     * Reads a volume of labels: whole numbers from 0 to 65535 in three dimensions, whatever type they are stored as.
     * Axes become LPS, spacing mm.
     *
     * @throws BadInputException if the file cannot be read, is of another format, is cut short or damaged, has other
     *     than three dimensions, voxels without size, axes that are not at right angles, or a value that is no label
     */
    public static LabelVolume read(Path file) {
        InputBytes.size(file);
        String name = name(file);
        if (name.endsWith(".nii") || name.endsWith(".nii.gz")) {
            return NiftiReader.read(file);
        }
        if (name.endsWith(".nrrd") || name.endsWith(".nhdr")) {
            return NrrdReader.read(file);
        }
        if (name.endsWith(".mha") || name.endsWith(".mhd")) {
            return MetaImageReader.read(file);
        }
        throw new BadInputException(file + ": found another ending, expected one of " + String.join(", ", READABLE));
    }

    private static String name(Path file) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    }
}
