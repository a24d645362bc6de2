package org.phrenic.ui.view;

import java.awt.image.BufferedImage;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;

/**
 * Reuses the images of frames: one is shown, one is on its way to the event dispatch thread, one is drawn into. While
 * all are in use the window cannot keep up, and another frame would not be seen. Thread-safe.
 */
final class ImagePool {
    private static final int MAX_IMAGES = 3;

    private final Queue<BufferedImage> free = new ArrayDeque<>();
    private int inUse;

    /** An image of this size; empty while all are in use. */
    synchronized Optional<BufferedImage> acquire(int width, int height) {
        if (inUse >= MAX_IMAGES) {
            return Optional.empty();
        }
        free.removeIf(image -> image.getWidth() != width || image.getHeight() != height);
        BufferedImage kept = free.poll();
        BufferedImage image = kept == null ? new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB) : kept;
        // An image that is refused for lack of memory is not in use.
        inUse++;
        return Optional.of(image);
    }

    synchronized void release(BufferedImage image) {
        inUse--;
        free.add(image);
    }
}
