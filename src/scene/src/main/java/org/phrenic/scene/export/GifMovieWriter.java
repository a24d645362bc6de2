package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.IIOImage;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.phrenic.file.AtomicFile;
import org.w3c.dom.Element;

/**
 * Writes an animated GIF that loops forever. Each frame has its own palette, made by ImageIO. Frame delays are whole
 * hundredths of a second, rounded so that their sum is correct.
 */
public final class GifMovieWriter implements MovieWriter {
    /** Maximum frame rate; viewers slow down faster movies. */
    public static final double MAX_FRAMES_PER_S = 50;

    private static final String FORMAT = "javax_imageio_gif_image_1.0";
    /** Netscape application extension: sub-block 1, loop count 0 (forever). */
    private static final byte[] LOOP_FOREVER = {1, 0, 0};

    @Override
    public void write(Path file, double framesPerS, Iterator<BufferedImage> frames) {
        if (!(framesPerS > 0 && framesPerS <= MAX_FRAMES_PER_S)) {
            throw new IllegalArgumentException(file + ": found " + framesPerS
                    + " pictures a second, expected more than 0 and at most 50 in a GIF");
        }
        AtomicFile.write(file, out -> write(out, framesPerS, frames));
    }

    private static void write(OutputStream out, double framesPerS, Iterator<BufferedImage> frames) throws IOException {
        ImageWriter writer = PngFile.writer("gif");
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.prepareWriteSequence(null);
            for (int i = 0; frames.hasNext(); i++) {
                BufferedImage picture = PngFile.flattened(frames.next());
                long delay = Math.round(100 * (i + 1) / framesPerS) - Math.round(100 * i / framesPerS);
                writer.writeToSequence(new IIOImage(picture, null, metadata(writer, picture, delay, i == 0)), null);
            }
            writer.endWriteSequence();
        } finally {
            writer.dispose();
        }
    }

    private static IIOMetadata metadata(ImageWriter writer, BufferedImage picture, long delay, boolean first)
            throws IIOInvalidTreeException {
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(picture), null);
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
        Element control =
                (Element) root.getElementsByTagName("GraphicControlExtension").item(0);
        control.setAttribute("delayTime", Long.toString(delay));
        control.setAttribute("disposalMethod", "none");
        if (first) {
            IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
            IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
            loop.setAttribute("applicationID", "NETSCAPE");
            loop.setAttribute("authenticationCode", "2.0");
            loop.setUserObject(LOOP_FOREVER.clone());
            extensions.appendChild(loop);
            root.appendChild(extensions);
        }
        metadata.setFromTree(FORMAT, root);
        return metadata;
    }
}
