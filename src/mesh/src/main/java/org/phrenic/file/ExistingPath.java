package org.phrenic.file;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** What there is of a path. */
public final class ExistingPath {
    private ExistingPath() {}

    /** A file or folder if it exists, else the nearest folder or file above it that does. */
    public static Optional<Path> nearest(Path path) {
        Path nearest = path.toAbsolutePath();
        while (nearest != null && !Files.exists(nearest)) {
            nearest = nearest.getParent();
        }
        return Optional.ofNullable(nearest);
    }
}
