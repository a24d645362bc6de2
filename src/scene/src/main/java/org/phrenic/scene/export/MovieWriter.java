package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Iterator;

/** A way to write pictures, one after another, into one file. */
public interface MovieWriter {
    /**
     * Writes a movie; it is there whole or not at all.
     *
     * @param file to write
     * @param framesPerS pictures a second
     * @param frames pictures of one size, made as they are asked for
     * @throws org.phrenic.format.OutputException if it cannot be written, with one sentence
     */
    void write(Path file, double framesPerS, Iterator<BufferedImage> frames);
}
