package org.phrenic.file;

import java.io.File;
import java.nio.charset.Charset;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Names of files. */
public final class FileNames {
    static final boolean ON_WINDOWS = File.separatorChar == '\\';
    private static final String RESERVED_CHARACTERS = "/\\:*?\"<>|";

    /** Names that Windows keeps for devices, whatever follows their first dot. */
    private static final Pattern DEVICE =
            Pattern.compile("(con|prn|aux|nul|com\\d|lpt\\d)(\\..*)?", Pattern.CASE_INSENSITIVE);

    /** Parts of a path that are no names. */
    private static final List<String> STEPS = List.of(".", "..");

    private FileNames() {}

    /**
     * The path that a text names.
     *
     * @throws BadInputException if this system has no such names
     */
    public static Path path(String text) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw new BadInputException(refusal(e), e);
        }
    }

    /** The absolute path that a text names, as an environment variable does; empty for null and for any other text. */
    public static Optional<Path> absolutePath(String text) {
        try {
            return Optional.ofNullable(text).map(Path::of).filter(Path::isAbsolute);
        } catch (InvalidPathException noPath) {
            return Optional.empty();
        }
    }

    /** Why a name is none here: letters that the encoding lacks, or else a character that names do not have. */
    static String refusal(InvalidPathException refused) {
        return isEncodable(refused.getInput())
                ? "found '" + refused.getInput() + "', expected the name of a file (" + refused.getReason() + ")"
                : "found a name that this system cannot write, expected one in the encoding of file names, "
                        + System.getProperty("sun.jnu.encoding") + " (LANG=C.UTF-8 allows all letters)";
    }

    private static boolean isEncodable(String name) {
        String encoding = System.getProperty("sun.jnu.encoding", "UTF-8");
        boolean hasUsualLetters = name.chars().allMatch(c -> c >= ' ' && c <= '~');
        boolean isText = name.chars().noneMatch(c -> c < ' ');
        return hasUsualLetters
                || (isText
                        && Charset.isSupported(encoding)
                        && Charset.forName(encoding).newEncoder().canEncode(name));
    }

    /** Whether this system can write a name. */
    public static boolean isOfSystem(String name) {
        try {
            return !Path.of(name).toString().isEmpty();
        } catch (InvalidPathException e) {
            return false;
        }
    }

    /**
     * Whether this system can have a file that a text names. Windows reads a device by some names, and a file of
     * another name by others.
     */
    public static boolean isUsable(String name) {
        return isOfSystem(name) && (!ON_WINDOWS || isPortable(Path.of(name)));
    }

    /**
     * What to call the body in a folder: the folder's name, or {@code body} for the root of a drive, which has none.
     */
    public static String ofBody(Path folder) {
        Path name = folder.toAbsolutePath().normalize().getFileName();
        return name == null || name.toString().isEmpty() ? "body" : name.toString();
    }

    /**
     * Name of a file without its folder and without what follows the last dot; whole where nothing stands before it.
     */
    public static String withoutExtension(Path file) {
        String name = String.valueOf(file.getFileName());
        String stem = name.replaceFirst("\\.[^.]*$", "");
        return stem.isBlank() ? name : stem;
    }

    /** Whether a file can have a name, with or without an extension, on Linux, macOS and Windows. */
    public static boolean isPortable(String name) {
        return !name.isBlank()
                && !name.endsWith(".")
                && !name.endsWith(" ")
                && !DEVICE.matcher(name).matches()
                && name.chars().noneMatch(c -> c < ' ' || RESERVED_CHARACTERS.indexOf(c) >= 0);
    }

    /** Whether a path is absolute, or one whose folders and file can have their names on Linux, macOS and Windows. */
    static boolean isPortable(Path path) {
        return path.isAbsolute()
                || Stream.iterate(path, Objects::nonNull, Path::getParent)
                        .map(part -> String.valueOf(part.getFileName()))
                        .allMatch(name -> STEPS.contains(name) || isPortable(name));
    }

    /** Files of one folder in the order of their names; paths themselves are ordered by the rules of the system. */
    public static List<Path> sorted(Stream<Path> files) {
        return files.sorted(Comparator.comparing(file -> String.valueOf(file.getFileName())))
                .toList();
    }

    /**
     * Whether a name begins with a dot. Such files are no input: {@code ._liver.nii.gz} holds what macOS knows of a
     * file beside it.
     */
    public static boolean isHidden(Path file) {
        return String.valueOf(file.getFileName()).startsWith(".");
    }

    /** Whether two paths name one place; links are not followed. */
    public static boolean isSamePlace(Path one, Path other) {
        return one.toAbsolutePath().normalize().equals(other.toAbsolutePath().normalize());
    }
}
