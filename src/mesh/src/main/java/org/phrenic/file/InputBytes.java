package org.phrenic.file;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Reads whole input files and lists folders of them; failures are reported in one sentence. */
public final class InputBytes {
    private static final long MAX_BYTES = Integer.MAX_VALUE - 64;

    private InputBytes() {}

    /**
     * Reads all of {@code file}.
     *
     * @throws BadInputException if the file is missing, a folder, unreadable, empty or larger than 2 GiB
     */
    public static byte[] read(Path file) {
        long size = size(file);
        if (size > MAX_BYTES) {
            throw new BadInputException(file + ": found " + size + " bytes, expected less than 2 GiB");
        }
        try {
            return Files.readAllBytes(file);
        } catch (IOException failure) {
            throw readFailure(file, failure);
        }
    }

    /**
     * Size of {@code file}, bytes.
     *
     * @throws BadInputException if the file is missing, a folder, a pipe or empty
     */
    public static long size(Path file) {
        if (Files.isDirectory(file)) {
            throw new BadInputException(file + ": found a folder, expected a file");
        }
        if (!Files.exists(file)) {
            throw missing(file, file.toAbsolutePath().getParent(), file + ": found no such file, expected one to read");
        }
        if (!Files.isRegularFile(file)) {
            throw new BadInputException(file + ": found a pipe or a device, expected a file");
        }
        try {
            long size = Files.size(file);
            if (size == 0) {
                throw new BadInputException(file + ": found an empty file, expected content");
            }
            return size;
        } catch (IOException failure) {
            throw readFailure(file, failure);
        }
    }

    /**
     * The entries of a folder, in the order of their names.
     *
     * @throws BadInputException if it cannot be read
     */
    public static List<Path> list(Path folder) {
        try (Stream<Path> entries = Files.list(folder)) {
            return FileNames.sorted(entries);
        } catch (IOException failure) {
            throw readFailure(folder, failure);
        }
    }

    /** A file that is missing. In a folder that is there, it is wrong to name it. */
    public static BadInputException missing(Path file, Path folder, String sentence) {
        return Files.isDirectory(folder)
                ? new BadInputException(sentence)
                : new UnreadableException(sentence, new NoSuchFileException(file.toString()));
    }

    /** Describes a read failure in one sentence. */
    public static UnreadableException readFailure(Path file, IOException failure) {
        return failure instanceof AccessDeniedException
                ? new UnreadableException(
                        file + ": found a file that may not be read, expected read permission", failure)
                : new UnreadableException(file + ": reading failed: " + failure.getMessage(), failure);
    }
}
