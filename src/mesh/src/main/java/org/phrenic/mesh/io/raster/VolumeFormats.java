package org.phrenic.mesh.io.raster;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.zip.ZipException;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;

/** The formats of volume files, by extension in upper or lower case. */
public final class VolumeFormats {
    private static final int GZIP_MAGIC = 0x1f8b;
    /** Extensions of the formats that can be read. */
    public static final List<String> READABLE = List.of("nii", "nii.gz", "nrrd", "nhdr", "mha", "mhd");

    private static final Pattern PACKED = Pattern.compile("\\.(zip|tar|tgz|tbz2?|txz|7z|rar|tar\\.\\w+)$");

    private VolumeFormats() {}

    /** Whether the name of a file has one of the extensions. */
    public static boolean isVolume(Path file) {
        String name = name(file);
        return READABLE.stream().anyMatch(ending -> name.endsWith("." + ending));
    }

    /** Whether the name of a file is that of an archive, which holds a folder. */
    public static boolean isPacked(Path file) {
        return PACKED.matcher(name(file)).find();
    }

    /**
     * Opens a volume and reads its voxels.
     *
     * @throws BadInputException if the file cannot be read, has another format, or is truncated or damaged
     */
    public static <T> T read(VolumeSource source, StoredVolume.Use<T> use) {
        Path file = source.path();
        InputBytes.size(file);
        String name = name(file);
        if (name.endsWith(".nii") || name.endsWith(".nii.gz")) {
            return read(file, "NIfTI file", in -> NiftiReader.read(source, in, use));
        }
        if (name.endsWith(".nrrd") || name.endsWith(".nhdr")) {
            return read(file, "NRRD file", in -> NrrdReader.read(source, in, use));
        }
        if (name.endsWith(".mha") || name.endsWith(".mhd")) {
            return read(file, "MetaImage", in -> MetaImageReader.read(source, in, use));
        }
        String expected = "expected one of " + String.join(", ", READABLE) + ", dcm";
        throw new BadInputException(file
                + (isPacked(file)
                        ? ": found a packed folder, " + expected + ": unpack it first"
                        : ": found another ending, " + expected));
    }

    private interface Format<T> {
        T read(BufferedInputStream in) throws IOException;
    }

    private static <T> T read(Path file, String name, Format<T> format) {
        try (BufferedInputStream in = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            return format.read(in);
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

    /** Whether the next bytes are those of a gzip stream; they are not consumed. */
    static boolean isGzip(InputStream in) throws IOException {
        in.mark(2);
        boolean is = (in.read() << 8 | in.read()) == GZIP_MAGIC;
        in.reset();
        return is;
    }
}
