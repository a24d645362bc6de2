package org.phrenic.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * Temporary files and folders that are being written. What is left of them when the program ends, such as by Ctrl+C, is
 * deleted then.
 */
public final class UnfinishedFiles {
    private static final Set<Path> PATHS = ConcurrentHashMap.newKeySet();

    static {
        try {
            Runtime.getRuntime().addShutdownHook(new Thread(() -> PATHS.forEach(UnfinishedFiles::delete)));
        } catch (IllegalStateException ending) {
            System.getLogger(UnfinishedFiles.class.getName())
                    .log(System.Logger.Level.DEBUG, "the program is ending", ending);
        }
    }

    private UnfinishedFiles() {}

    /** Adds a temporary file, or a folder of such files. */
    public static void add(Path path) {
        PATHS.add(path.toAbsolutePath());
    }

    /** Removes a file or folder, which is complete or deleted. */
    public static void remove(Path path) {
        PATHS.remove(path.toAbsolutePath());
    }

    private static void delete(Path path) {
        try {
            if (Files.isDirectory(path)) {
                try (Stream<Path> files = Files.list(path)) {
                    files.forEach(UnfinishedFiles::delete);
                }
            }
            Files.deleteIfExists(path);
        } catch (IOException e) {
            System.getLogger(UnfinishedFiles.class.getName())
                    .log(System.Logger.Level.DEBUG, "temporary file stays: " + path, e);
        }
    }
}
