package org.phrenic.study;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.function.Function;

/** Data files distributed with the program, below {@code data/}. */
public final class ShippedFile {
    private ShippedFile() {}

    /**
     * Reads a file; empty if it does not exist.
     *
     * @param path such as {@code validation/physiology.yaml}
     */
    public static <T> Optional<T> read(String path, Function<InputStream, T> reader) {
        try (InputStream in = ShippedFile.class.getResourceAsStream("/org/phrenic/data/" + path)) {
            return in == null ? Optional.empty() : Optional.of(reader.apply(in));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
