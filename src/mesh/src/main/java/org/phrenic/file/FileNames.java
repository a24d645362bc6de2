package org.phrenic.file;

import java.nio.file.Path;

/** Names of files. */
public final class FileNames {
    private FileNames() {}

    /** Name of a file without its folder and without what follows the last dot. */
    public static String withoutExtension(Path file) {
        return String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
    }
}
