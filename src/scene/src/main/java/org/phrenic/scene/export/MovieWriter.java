package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Iterator;

/** Writes a sequence of pictures into one file. */
public interface MovieWriter {
    /**
     * Writes a movie, as a whole or not at all.
     *
     * @param frames pictures of one size, drawn on demand
     * @throws org.phrenic.file.OutputException if it cannot be written, with one sentence
     */
    void write(Path file, double framesPerS, Iterator<BufferedImage> frames);
}
