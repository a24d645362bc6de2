package org.phrenic.document;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Data files distributed with the program, named by their path below {@code data/}. */
public final class ShippedFile {
    private ShippedFile() {}

    /** The content of a file; empty if there is none. */
    public static Optional<String> find(String path) {
        try (InputStream in = ShippedFile.class.getResourceAsStream("/org/phrenic/data/" + path)) {
            return in == null ? Optional.empty() : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new ShippedFileException("data/" + path + " of the program cannot be read: " + e.getMessage(), e);
        }
    }

    /** The content of a file that must be there. */
    public static String text(String path) {
        return find(path)
                .orElseThrow(() -> new ShippedFileException("data/" + path + " is missing from the program", null));
    }

    /** A YAML file that must be there; error messages name it without its folder. */
    public static YamlMap yaml(String path) {
        return YamlDocument.parse(path.substring(path.lastIndexOf('/') + 1), text(path));
    }
}
