package org.phrenic.scene.export;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.OutputException;

/** Writes opaque PNG files atomically. */
public final class PngFile {
    /** Larger pictures have the usual compression level instead of the highest one, for speed. */
    private static final long MOST_PIXELS = 3_000_000;

    private PngFile() {}

    /**
     * Writes a picture; translucent pixels are blended with white.
     *
     * @throws OutputException if the file cannot be written; the message is one sentence
     */
    public static void write(Path file, BufferedImage picture) {
        BufferedImage opaque = flattened(picture);
        long pixels = (long) opaque.getWidth() * opaque.getHeight();
        AtomicFile.write(file, out -> {
            ImageWriter writer = writer("png");
            try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
                ImageWriteParam parameters = writer.getDefaultWriteParam();
                if (parameters.canWriteCompressed() && pixels <= MOST_PIXELS) {
                    parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
                    // The quality of a lossless format is its speed: 0 is the highest compression.
                    parameters.setCompressionQuality(0);
                }
                writer.setOutput(stream);
                writer.write(null, new IIOImage(opaque, null, null), parameters);
            } finally {
                writer.dispose();
            }
        });
    }

    static ImageWriter writer(String format) throws IOException {
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName(format);
        if (!writers.hasNext()) {
            throw new IOException("this Java has no writer of " + format.toUpperCase(Locale.ROOT));
        }
        return writers.next();
    }

    /** The picture blended with white, without an alpha channel; the same object if it has none. */
    static BufferedImage flattened(BufferedImage picture) {
        if (picture.getType() == BufferedImage.TYPE_INT_RGB) {
            return picture;
        }
        BufferedImage opaque = new BufferedImage(picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = opaque.createGraphics();
        g.drawImage(picture, 0, 0, Color.WHITE, null);
        g.dispose();
        return opaque;
    }
}
