package org.phrenic.ui.view;

import java.awt.image.BufferedImage;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Images that are drawn into and shown in turns, so that no frame makes one: one on the screen, one on its way there,
 * one being drawn. When all are out the screen cannot keep up, and drawing another picture would be for nothing.
 */
final class ImagePool {
    private static final int MAX_IMAGES = 3;

    private final ReentrantLock lock = new ReentrantLock();
    private final Queue<BufferedImage> free = new ArrayDeque<>();
    private int inUse;

    /** An image of this size to draw into; empty while all are out. */
    Optional<BufferedImage> acquire(int width, int height) {
        lock.lock();
        try {
            if (inUse >= MAX_IMAGES) {
                return Optional.empty();
            }
            inUse++;
            free.removeIf(image -> image.getWidth() != width || image.getHeight() != height);
            BufferedImage kept = free.poll();
            return Optional.of(kept == null ? new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB) : kept);
        } finally {
            lock.unlock();
        }
    }

    /** Takes back what is no longer shown. */
    void release(BufferedImage image) {
        lock.lock();
        try {
            inUse--;
            free.add(image);
        } finally {
            lock.unlock();
        }
    }
}
