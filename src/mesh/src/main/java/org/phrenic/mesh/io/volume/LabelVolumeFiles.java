package org.phrenic.mesh.io.volume;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.zip.ZipException;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;

/** Reads label volume files. The extension, in upper or lower case, gives the format. */
public final class LabelVolumeFiles {
    /** Extensions of the formats that can be read. */
    public static final List<String> READABLE = List.of("nii", "nii.gz", "nrrd", "nhdr", "mha", "mhd");

    private LabelVolumeFiles() {}

    /** Whether {@code file} has a volume file extension; the file need not exist. */
    public static boolean isVolume(Path file) {
        String name = name(file);
        return READABLE.stream().anyMatch(ending -> name.endsWith("." + ending));
    }

    /**
     * Reads a three-dimensional volume of labels, whole numbers from 0 to 65535 stored in any type. Axes are converted
     * to LPS and spacing to mm.
     *
     * @throws BadInputException if the file cannot be read, has another format, is truncated or damaged, is not
     *     three-dimensional, has a voxel spacing of 0, axes that are not orthogonal, or a value that is not a label
     */
    public static LabelVolume read(Path file) {
        InputBytes.size(file);
        String name = name(file);
        if (name.endsWith(".nii") || name.endsWith(".nii.gz")) {
            return read(file, "NIfTI-1 file", NiftiReader::read);
        }
        if (name.endsWith(".nrrd") || name.endsWith(".nhdr")) {
            return read(file, "NRRD file", NrrdReader::read);
        }
        if (name.endsWith(".mha") || name.endsWith(".mhd")) {
            return read(file, "MetaImage", MetaImageReader::read);
        }
        throw new BadInputException(file + ": found another ending, expected one of " + String.join(", ", READABLE));
    }

    /**
     * Refuses a label volume where something else is expected.
     *
     * @param expected such as "a scenario"
     * @throws BadInputException if the file has the extension of a volume and is no folder
     */
    public static void refuse(Path file, String expected) {
        if (isVolume(file) && !Files.isDirectory(file)) {
            throw new BadInputException(file + ": found a label volume, expected " + expected
                    + "; phrenic import makes a thorax folder of it: phrenic import " + file + " --out patient");
        }
    }

    private interface Format {
        LabelVolume read(Path file, BufferedInputStream in) throws IOException;
    }

    private static LabelVolume read(Path file, String name, Format format) {
        try (BufferedInputStream in = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            return format.read(file, in);
        } catch (ZipException | EOFException damaged) {
            throw new BadInputException(
                    file + ": found data that is damaged or ends too early, expected a whole " + name, damaged);
        } catch (IOException failure) {
            throw InputBytes.readFailure(file, failure);
        }
    }

    private static String name(Path file) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    }
}
