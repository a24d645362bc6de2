package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Iterator;

/** Writes a sequence of pictures into one file. */
public interface MovieWriter {
    /**
     * Writes a movie atomically.
     *
     * @param frames pictures of equal size, drawn on demand
     * @throws org.phrenic.file.OutputException if the file cannot be written; the message is one sentence
     */
    void write(Path file, double framesPerS, Iterator<BufferedImage> frames);
}
