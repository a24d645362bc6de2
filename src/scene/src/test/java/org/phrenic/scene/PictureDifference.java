package org.phrenic.scene;

import java.awt.image.BufferedImage;

/**
 * How far two pictures of one size are apart, looked at from so far away that edges which another driver draws a little
 * otherwise do not count: means of red, green and blue over blocks of pixels.
 *
 * @param mean of all blocks and colours, 0 to 255
 * @param largest of a block and colour, 0 to 255
 */
public record PictureDifference(double mean, double largest) {
    private static final int BLOCK = 10;

    /** Other drivers round and smooth otherwise; that stays below these. */
    private static final double LIKE_MEAN = 1.5;

    private static final double LIKE_LARGEST = 14;

    public static PictureDifference of(BufferedImage a, BufferedImage b) {
        if (a.getWidth() != b.getWidth() || a.getHeight() != b.getHeight()) {
            return new PictureDifference(255, 255);
        }
        double sum = 0;
        double largest = 0;
        int count = 0;
        for (int y = 0; y < a.getHeight(); y += BLOCK) {
            for (int x = 0; x < a.getWidth(); x += BLOCK) {
                for (int shift = 0; shift <= 16; shift += 8) {
                    double apart = Math.abs(mean(a, x, y, shift) - mean(b, x, y, shift));
                    sum += apart;
                    largest = Math.max(largest, apart);
                    count++;
                }
            }
        }
        return new PictureDifference(sum / count, largest);
    }

    private static double mean(BufferedImage image, int x0, int y0, int shift) {
        double sum = 0;
        int count = 0;
        for (int y = y0; y < Math.min(image.getHeight(), y0 + BLOCK); y++) {
            for (int x = x0; x < Math.min(image.getWidth(), x0 + BLOCK); x++) {
                sum += image.getRGB(x, y) >> shift & 0xff;
                count++;
            }
        }
        return sum / count;
    }

    /** Whether both show the same. */
    boolean isAlike() {
        return mean <= LIKE_MEAN && largest <= LIKE_LARGEST;
    }
}
