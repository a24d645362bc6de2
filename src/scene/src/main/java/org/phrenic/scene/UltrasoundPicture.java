package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import org.phrenic.access.ultrasound.BModeImage;
import org.phrenic.scene.export.PngFile;

/**
 * Pictures of {@link BModeImage}s: grey levels, a mark for each centimetre of depth, the probe's marker on the left.
 */
public final class UltrasoundPicture {
    private static final int MARK_RGB = 0xffb0b0b0;
    private static final int MARKER_RGB = 0xff4f9de0;
    private static final int TICK = 4;
    private static final int LONG_TICK = 9;
    private static final int MARKER = 5;

    private UltrasoundPicture() {}

    /** The picture of an image, as many pixels as it has. */
    public static BufferedImage of(BModeImage image) {
        int size = BModeImage.SIZE;
        BufferedImage picture = new BufferedImage(size, size, BufferedImage.TYPE_INT_RGB);
        byte[] grey = image.grey();
        for (int i = 0; i < grey.length; i++) {
            picture.setRGB(i % size, i / size, (grey[i] & 0xff) * 0x010101);
        }
        double[] face = image.pixelOf(image.pose().face());
        int centimetres = (int) (image.settings().depthMm() / 10);
        for (int cm = 0; cm <= centimetres; cm++) {
            int row = (int) Math.round(face[1] + 10 * cm / image.mmPerPixel());
            int length = cm % 5 == 0 ? LONG_TICK : TICK;
            for (int k = 0; k < length && row < size; k++) {
                picture.setRGB(size - 1 - k, row, MARK_RGB);
            }
        }
        int column = (int) Math.round(face[0] - 0.22 * size);
        for (int y = -MARKER; y <= MARKER; y++) {
            for (int x = -MARKER; x <= MARKER; x++) {
                if (x * x + y * y <= MARKER * MARKER) {
                    picture.setRGB(column + x, MARKER + 1 + y, MARKER_RGB);
                }
            }
        }
        return picture;
    }

    /** Writes the picture as a PNG file. */
    public static void write(Path file, BModeImage image) {
        PngFile.write(file, of(image));
    }
}
