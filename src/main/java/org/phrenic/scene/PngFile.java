package org.phrenic.scene;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.phrenic.format.AtomicFile;
import org.phrenic.format.OutputException;

/** A picture as a PNG file: opaque, whole or not there. */
public final class PngFile {
    private PngFile() {}

    /**
     * Writes a picture; where it is translucent, white shows through.
     *
     * @throws OutputException if it cannot be written, with one sentence
     */
    public static void write(Path file, BufferedImage picture) {
        BufferedImage opaque = opaque(picture);
        AtomicFile.write(file, out -> {
            try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
                if (!ImageIO.write(opaque, "png", stream)) {
                    throw new IOException("this Java has no writer of PNG");
                }
            }
        });
    }

    /** The picture on white without an alpha channel; itself if it has none. */
    static BufferedImage opaque(BufferedImage picture) {
        if (picture.getType() == BufferedImage.TYPE_INT_RGB) {
            return picture;
        }
        BufferedImage opaque = new BufferedImage(picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = opaque.createGraphics();
        g.drawImage(picture, 0, 0, java.awt.Color.WHITE, null);
        g.dispose();
        return opaque;
    }
}
