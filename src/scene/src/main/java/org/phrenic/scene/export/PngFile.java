package org.phrenic.scene.export;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.OutputException;

/** A picture as a PNG file: opaque, whole or not there. */
public final class PngFile {
    /** Up to this size a picture is made as small a file as can be; beyond, that takes too long. */
    private static final long MAX_COMPRESSED_PIXELS = 3_000_000;

    private PngFile() {}

    /**
     * Writes a picture; where it is translucent, white shows through.
     *
     * @throws OutputException if it cannot be written, with one sentence
     */
    public static void write(Path file, BufferedImage picture) {
        BufferedImage opaque = flattened(picture);
        AtomicFile.write(file, out -> {
            Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName("png");
            if (!writers.hasNext()) {
                throw new IOException("this Java has no writer of PNG");
            }
            ImageWriter writer = writers.next();
            try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
                ImageWriteParam parameters = writer.getDefaultWriteParam();
                if (parameters.canWriteCompressed() && pixels(opaque) <= MAX_COMPRESSED_PIXELS) {
                    parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
                    parameters.setCompressionQuality(0);
                }
                writer.setOutput(stream);
                writer.write(null, new IIOImage(opaque, null, null), parameters);
            } finally {
                writer.dispose();
            }
        });
    }

    private static long pixels(BufferedImage picture) {
        return (long) picture.getWidth() * picture.getHeight();
    }

    /** The picture on white without an alpha channel; itself if it has none. */
    static BufferedImage flattened(BufferedImage picture) {
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
